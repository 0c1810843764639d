package io.github.sofas.export;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.flow.Segment;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;

/**
 * The figures of one run over one recording, and their form as JSON.
 *
 * @param version version of the program
 * @param request fingerprint of everything that determines the results, by which existing results are recognised; empty
 *     if the results cannot be made again
 * @param recording summary of the recording
 * @param method name of the method that labelled the events
 * @param preset name of the preset from which the parameters started; empty if the method has none
 * @param parameters every parameter by its option's name: a Number, Boolean or String each
 * @param eventsWithFlow number of the recording's events that have flow
 * @param withoutFlow reason why most events found no flow, in words; empty if half of them or more have flow
 * @param segments all track planes
 * @param eventsDropped number of events that were not delivered, by reason
 * @param seconds where the time went
 * @param peakHeapBytes most heap in use by the whole program until now, other recordings included
 */
public record RunSummary(String version, String request, RecordingSummary recording, String method, String preset,
                         Map<String, Object> parameters, long eventsWithFlow, String withoutFlow,
                         List<Segment> segments, Map<String, Long> eventsDropped, Seconds seconds,
                         long peakHeapBytes) {
    /**
     * Name of a parameter: the time in ms up to which a label depends on later events. Labels that look ahead have it,
     * others do not.
     */
    public static final String LOOK_AHEAD = "look-ahead-ms";
    /** Least share of the events with flow that a segment holds to be counted. */
    public static final double LEAST_SHARE = 0.01;

    /**
     * Where the time went, in seconds.
     *
     * @param wall from the opening of the recording to its last event written
     * @param decode reading and decoding
     * @param engine flow and segments
     * @param output making and writing the rows
     */
    public record Seconds(double wall, double decode, double engine, double output) {
    }

    /** {@return whether each label depends only on events before its own} */
    public boolean isCausal() {
        return !parameters.containsKey(LOOK_AHEAD);
    }

    /** {@return the share of the events that have flow, 0 to 1; 0 if there is no event} */
    public double shareWithFlow() {
        return recording.events() == 0 ? 0 : (double) eventsWithFlow / recording.events();
    }

    /** {@return events per second of wall time; 0 if no time passed} */
    public double eventsPerSecond() {
        return seconds.wall > 0 ? recording.events() / seconds.wall : 0;
    }

    /**
     * {@return the number of track planes with a given fate}
     *
     * @param fate how they ended
     */
    public long count(Segment.Fate fate) {
        return segments.stream().filter(segment -> segment.fate() == fate).count();
    }

    /**
     * {@return the number of track planes that a person would count} These hold at least a hundredth of the events with
     * flow, including the events of planes merged into them.
     */
    public long countLarge() {
        return segments.stream().filter(segment -> segment.fate() != Segment.Fate.MERGED
            && segment.events() > 0 && segment.events() >= LEAST_SHARE * eventsWithFlow).count();
    }

    /**
     * Writes a JSON document and leaves the stream open.
     *
     * @param out receives the text; left open
     * @param fileBytes sizes of the other results of the run, by name
     * @throws IOException if the document cannot be written
     */
    public void write(OutputStream out, Map<String, Long> fileBytes) throws IOException {
        try (JsonGenerator json = Json.open(out)) {
            json.writeStartObject();
            json.writeStringField("version", version);
            if (!request.isEmpty()) {
                json.writeStringField("request", request);
            }
            json.writeFieldName("recording");
            recording.write(json);
            json.writeStringField("method", method);
            json.writeStringField("preset", preset);
            json.writeBooleanField("causal", isCausal());
            json.writeFieldName("parameters");
            Json.writeParameters(json, parameters);
            json.writeNumberField("events", recording.events());
            json.writeNumberField("events_with_flow", eventsWithFlow);
            Json.write(json, "share_with_flow", shareWithFlow(), 6);
            if (!withoutFlow.isEmpty()) {
                json.writeStringField("without_flow", withoutFlow);
            }
            json.writeObjectFieldStart("events_dropped");
            for (Map.Entry<String, Long> dropped : eventsDropped.entrySet()) {
                json.writeNumberField(dropped.getKey(), dropped.getValue());
            }
            json.writeEndObject();
            json.writeObjectFieldStart("segments");
            json.writeNumberField("all", segments.size());
            json.writeNumberField("of_1_percent", countLarge());
            json.writeNumberField("alive", count(Segment.Fate.ALIVE));
            json.writeNumberField("merged", count(Segment.Fate.MERGED));
            json.writeNumberField("removed", count(Segment.Fate.REMOVED));
            json.writeEndObject();
            json.writeObjectFieldStart("seconds");
            Json.write(json, "wall", seconds.wall, 6);
            Json.write(json, "decode", seconds.decode, 6);
            Json.write(json, "engine", seconds.engine, 6);
            Json.write(json, "output", seconds.output, 6);
            json.writeEndObject();
            Json.write(json, "events_per_second", eventsPerSecond(), 1);
            json.writeNumberField("peak_heap_bytes", peakHeapBytes);
            json.writeObjectFieldStart("file_bytes");
            for (Map.Entry<String, Long> file : fileBytes.entrySet()) {
                json.writeNumberField(file.getKey(), file.getValue());
            }
            json.writeEndObject();
            json.writeEndObject();
        }
    }

    /**
     * {@return all parameters as a JSON object, as the summary holds them}
     *
     * @param parameters values by name
     * @throws IOException if a value cannot be written
     */
    public static String parametersAsJson(Map<String, Object> parameters) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = Json.open(bytes)) {
            Json.writeParameters(json, parameters);
        }
        return bytes.toString(StandardCharsets.UTF_8).strip();
    }
}
