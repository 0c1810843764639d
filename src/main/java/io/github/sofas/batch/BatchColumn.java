package io.github.sofas.batch;

import java.time.Instant;
import java.util.Locale;

/** A column of the table that a batch gives, one row for each recording; empty where a recording has no results. */
public enum BatchColumn {
    /** As it was found. */
    RECORDING(String.class, null),
    /** Of the results. */
    NAME(String.class, null),
    /** {@code complete}, {@code damaged} (results of what is before the damage) or {@code failed} (no results). */
    OUTCOME(String.class, null),
    /** What is wrong, as {@code run} says it; empty where nothing is. */
    FAULT(String.class, null),
    /** Whether the results are those of an earlier batch. */
    EARLIER(Boolean.class, null),
    /** Name and version of the recording's format. */
    FORMAT(String.class, "/recording/format"),
    /** Sensor chip. */
    CHIP(String.class, "/recording/chip"),
    /** Of the sensor, px. */
    WIDTH(Long.class, "/recording/width"),
    /** Of the sensor, px. */
    HEIGHT(Long.class, "/recording/height"),
    /** DVS events. */
    EVENTS(Long.class, "/recording/events"),
    /** Time of the first one, µs. */
    FIRST_T_US(Long.class, "/recording/first_t_us"),
    /** Time of the last one, µs. */
    LAST_T_US(Long.class, "/recording/last_t_us"),
    /** From the first event to the last, s. */
    DURATION_S(Double.class, "/recording/duration_s"),
    /** Of the recording. */
    EVENTS_PER_S(Double.class, "/recording/events_per_s"),
    /** Share of the events that were corrected, dropped or malformed, 0 to 1. */
    DOUBTFUL_SHARE(Double.class, "/recording/doubtful_share"),
    /** That labelled the events. */
    METHOD(String.class, "/method"),
    /** That its parameters started from. */
    PRESET(String.class, "/preset"),
    /** Every parameter, as {@code name=value}, in the order of names. */
    PARAMETERS(String.class, null),
    /** Events with flow. */
    EVENTS_WITH_FLOW(Long.class, "/events_with_flow"),
    /** Their share, 0 to 1. */
    SHARE_WITH_FLOW(Double.class, "/share_with_flow"),
    /** Likely reason where most events have no flow. */
    WITHOUT_FLOW(String.class, "/without_flow"),
    /** Events that were not delivered, for any reason. */
    EVENTS_DROPPED(Long.class, null),
    /** Track planes. */
    SEGMENTS(Long.class, "/segments/all"),
    /** Those that hold a hundredth of the events with flow. */
    SEGMENTS_OF_1_PERCENT(Long.class, "/segments/of_1_percent"),
    /** From the opening to the last event written. */
    WALL_S(Double.class, "/seconds/wall"),
    /** Of these, reading. */
    DECODE_S(Double.class, "/seconds/decode"),
    /** Of these, labelling. */
    ENGINE_S(Double.class, "/seconds/engine"),
    /** Of these, writing. */
    OUTPUT_S(Double.class, "/seconds/output"),
    /** Events per second of wall time. */
    LABELLED_PER_S(Double.class, "/events_per_second"),
    /** Most heap that the process had in use until then. */
    PEAK_HEAP_BYTES(Long.class, "/peak_heap_bytes"),
    /** Of the program. */
    VERSION(String.class, "/version"),
    /** Size of the recording. */
    RECORDING_BYTES(Long.class, null),
    /** Size of its results, without the summary. */
    RESULT_BYTES(Long.class, null),
    /** When its task began. */
    TASK_STARTED(Instant.class, null),
    /** How long the task took, fetching and storing included. */
    TASK_S(Double.class, null),
    /** Which attempt it was, from 0. */
    TASK_ATTEMPT(Long.class, null),
    /** Where it ran. */
    HOST(String.class, null);

    private final Class<?> type;
    private final String pointer;

    BatchColumn(Class<?> type, String pointer) {
        this.type = type;
        this.pointer = pointer;
    }

    /** {@return its name in the table} */
    public String columnName() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** {@return what its values are: String, Long, Double, Boolean or Instant} */
    public Class<?> type() {
        return type;
    }

    /** {@return where the summary of a recording has its value, as a JSON pointer; null where it has not} */
    public String pointer() {
        return pointer;
    }
}
