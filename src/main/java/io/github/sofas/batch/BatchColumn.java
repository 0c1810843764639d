package io.github.sofas.batch;

import java.time.Instant;
import java.util.Locale;

/** A column of the table that a batch writes, with one row per recording. Empty if a recording has no such value. */
public enum BatchColumn {
    /** The recording, by the name under which it was found. */
    RECORDING(String.class, null),
    /** Name of the results. */
    NAME(String.class, null),
    /** {@code complete}, {@code damaged} (results up to the damage) or {@code failed} (no results). */
    OUTCOME(String.class, null),
    /** What is wrong with the recording, in the words of {@code run}; empty if nothing is wrong. */
    FAULT(String.class, null),
    /** Whether the results are of an earlier batch or run, left as they were. */
    EARLIER(Boolean.class, null),
    /** Name and version of the recording's format. */
    FORMAT(String.class, "/recording/format"),
    /** Sensor chip. */
    CHIP(String.class, "/recording/chip"),
    /** Width of the sensor, px. */
    WIDTH(Long.class, "/recording/width"),
    /** Height of the sensor, px. */
    HEIGHT(Long.class, "/recording/height"),
    /** Number of DVS events. */
    EVENTS(Long.class, "/recording/events"),
    /** Time of the first event, µs. */
    FIRST_T_US(Long.class, "/recording/first_t_us"),
    /** Time of the last event, µs. */
    LAST_T_US(Long.class, "/recording/last_t_us"),
    /** Time from the first event to the last, s. */
    DURATION_S(Double.class, "/recording/duration_s"),
    /** Event rate of the recording, events/s. */
    EVENTS_PER_S(Double.class, "/recording/events_per_s"),
    /** Share of the events that were corrected, dropped or malformed, 0 to 1. */
    DOUBTFUL_SHARE(Double.class, "/recording/doubtful_share"),
    /** Name of the method that labelled the events. */
    METHOD(String.class, "/method"),
    /** Preset that the parameters started from. */
    PRESET(String.class, "/preset"),
    /** Every parameter, as {@code name=value}, in the order of names. */
    PARAMETERS(String.class, null),
    /** Number of events with flow. */
    EVENTS_WITH_FLOW(Long.class, "/events_with_flow"),
    /** Share of the events that have flow, 0 to 1. */
    SHARE_WITH_FLOW(Double.class, "/share_with_flow"),
    /** Likely reason why most events have no flow; empty if half of them or more have flow. */
    WITHOUT_FLOW(String.class, "/without_flow"),
    /** Number of events that were not delivered, for any reason. */
    EVENTS_DROPPED(Long.class, null),
    /** Number of track planes. */
    SEGMENTS(Long.class, "/segments/all"),
    /** Number of track planes that hold at least a hundredth of the events with flow. */
    SEGMENTS_OF_1_PERCENT(Long.class, "/segments/of_1_percent"),
    /** Time from the opening of the recording to the last event written, s. */
    WALL_S(Double.class, "/seconds/wall"),
    /** Time spent on reading and decoding, s. */
    DECODE_S(Double.class, "/seconds/decode"),
    /** Time spent on labelling, s. */
    ENGINE_S(Double.class, "/seconds/engine"),
    /** Time spent on writing, s. */
    OUTPUT_S(Double.class, "/seconds/output"),
    /** Events labelled per second of wall time. */
    LABELLED_PER_S(Double.class, "/events_per_second"),
    /** Most heap that the process had in use up to the end of the run, bytes. */
    PEAK_HEAP_BYTES(Long.class, "/peak_heap_bytes"),
    /** Version of the program. */
    VERSION(String.class, "/version"),
    /** Size of the recording, bytes. */
    RECORDING_BYTES(Long.class, null),
    /** Size of the recording's results without the summary, bytes. */
    RESULT_BYTES(Long.class, null),
    /** When the recording's task began. */
    TASK_STARTED(Instant.class, null),
    /** Time that the task took, including fetching and storing, s. */
    TASK_S(Double.class, null),
    /** Number of the attempt, from 0. */
    TASK_ATTEMPT(Long.class, null),
    /** Host that the task ran on. */
    HOST(String.class, null);

    private final Class<?> type;
    private final String pointer;

    BatchColumn(Class<?> type, String pointer) {
        this.type = type;
        this.pointer = pointer;
    }

    /** {@return the name of the column in the table} */
    public String columnName() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** {@return the type of the column's values: String, Long, Double, Boolean or Instant} */
    public Class<?> type() {
        return type;
    }

    /** {@return the place of the value in a recording's summary, as a JSON pointer; null if the summary has none} */
    public String pointer() {
        return pointer;
    }
}
