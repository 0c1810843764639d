package io.github.sofas.benchmark;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.export.Json;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Report of a benchmark, as text for people, as JSON for programs, and as a plot of the cost per event.
 *
 * @param machine the machine that the figures were taken on
 * @param recordings figures of each recording, in the order of measurement
 */
public record BenchmarkReport(Machine machine, List<RecordingFigures> recordings) {

    /** Describes the machine for people, in lines that end in LF. */
    public static String text(Machine machine) {
        return String.format(Locale.ROOT, "machine  %s, %d cores, %.1f GB; %s; load %.1f\n",
            machine.cpu(), machine.cores(), machine.memoryBytes() / 1e9, machine.os(), machine.load())
            + String.format(Locale.ROOT, "jvm      %s; %s; heap up to %.0f MB\n", machine.jvm(),
                String.join(" ", machine.jvmOptions()), machine.maxHeapBytes() / 1e6);
    }

    /** Shows the figures of one recording for people, in lines that end in LF. */
    public static String text(RecordingFigures figures) {
        EngineFigures engine = figures.figures();
        StringBuilder text = new StringBuilder();
        text.append(String.format(Locale.ROOT, "%s: %s, %s, %d events, %.1f %% with flow; %d runs\n",
            figures.recording(), figures.format(), engine.sensor(), figures.engine().events(),
            100 * engine.shareWithFlow(), figures.engine().runs()));
        text.append(String.format(Locale.ROOT, "  %-14s %12s %12s %12s %10s %10s  %s\n", "events/s", "minimum",
            "median", "maximum", "ns/event", "of the CPU", "checksum"));
        rates(text, "engine", figures.engine());
        rates(text, "engine, helped", figures.helped());
        rates(text, "decode", figures.decode());
        rates(text, "CSV", figures.csv());
        rates(text, "whole run", figures.run());
        text.append("  time           ");
        String separator = "";
        for (Map.Entry<Stage, Double> share : figures.shares().entrySet()) {
            text.append(separator).append(share.getKey().title())
                .append(String.format(Locale.ROOT, " %.1f %%", 100 * share.getValue()));
            separator = ", ";
        }
        text.append('\n');
        text.append(String.format(Locale.ROOT, "  %-30s %9s %9s %9s %9s %9s\n", "packets, ms", "packets", "p50", "p99",
            "p99.9", "longest"));
        latency(text, "1 ms of the recording", engine.packets().ofOneMs());
        latency(text, PacketTimes.PACED_EVENTS + " events, one each ms", engine.packets().paced());
        latency(text, "of which worked on", engine.packets().pacedWork());
        text.append(String.format(Locale.ROOT, "  density        %.0f events with flow while what they show "
            + "travels 1 px\n", engine.eventsPerPx()));
        text.append(String.format(Locale.ROOT, "  memory         %.3f bytes allocated per event, engine holds %.1f MB, "
            + "peak heap of a whole run %.1f MB\n", engine.allocatedBytesPerEvent(), engine.heldBytes() / 1e6,
            figures.peakHeapBytes() / 1e6));
        return text.toString();
    }

    private static void rates(StringBuilder text, String part, Rates rates) {
        text.append(String.format(Locale.ROOT, "  %-14s %12.0f %12.0f %12.0f %10.1f %10.1f  %s\n", part,
            rates.minPerS(), rates.medianPerS(), rates.maxPerS(), rates.medianNsPerEvent(), rates.cpuNsPerEvent(),
            rates.checksum()));
    }

    private static void latency(StringBuilder text, String packets, Latency latency) {
        text.append(String.format(Locale.ROOT, "  %-30s %9d %9.3f %9.3f %9.3f %9.3f\n", packets, latency.packets(),
            latency.p50Ns() / 1e6, latency.p99Ns() / 1e6, latency.p999Ns() / 1e6, latency.maxNs() / 1e6));
    }

    /**
     * Writes the report as a JSON document. Leaves the stream open.
     *
     * @throws IOException if the document cannot be written
     */
    public void write(OutputStream out) throws IOException {
        try (JsonGenerator json = Json.open(out)) {
            json.writeStartObject();
            json.writeObjectFieldStart("machine");
            json.writeStringField("cpu", machine.cpu());
            json.writeNumberField("cores", machine.cores());
            json.writeNumberField("memory_bytes", machine.memoryBytes());
            json.writeStringField("os", machine.os());
            json.writeStringField("jvm", machine.jvm());
            json.writeArrayFieldStart("jvm_options");
            for (String option : machine.jvmOptions()) {
                json.writeString(option);
            }
            json.writeEndArray();
            json.writeNumberField("max_heap_bytes", machine.maxHeapBytes());
            Json.write(json, "load", machine.load(), 2);
            json.writeEndObject();
            json.writeArrayFieldStart("recordings");
            for (RecordingFigures figures : recordings) {
                write(json, figures);
            }
            json.writeEndArray();
            json.writeEndObject();
        }
    }

    /**
     * Plots the cost per event over the density of events, as a PNG. Leaves the stream open.
     *
     * @throws IOException if the picture cannot be written
     */
    public void plot(OutputStream out) throws IOException {
        CostPlot.write(recordings, out);
    }

    private static void write(JsonGenerator json, RecordingFigures figures) throws IOException {
        EngineFigures engine = figures.figures();
        json.writeStartObject();
        json.writeStringField("recording", figures.recording());
        json.writeStringField("format", figures.format());
        json.writeNumberField("width", engine.sensor().width());
        json.writeNumberField("height", engine.sensor().height());
        json.writeNumberField("events", figures.engine().events());
        json.writeObjectFieldStart("engine");
        write(json, figures.engine());
        Json.write(json, "share_with_flow", engine.shareWithFlow(), 6);
        Json.write(json, "events_per_px", engine.eventsPerPx(), 1);
        Json.write(json, "allocated_bytes_per_event", engine.allocatedBytesPerEvent(), 4);
        json.writeNumberField("held_bytes", engine.heldBytes());
        write(json, "latency_1_ms", engine.packets().ofOneMs());
        write(json, "latency_paced", engine.packets().paced());
        write(json, "latency_paced_work", engine.packets().pacedWork());
        json.writeEndObject();
        write(json, "engine_helped", figures.helped());
        write(json, "decode", figures.decode());
        write(json, "csv", figures.csv());
        json.writeObjectFieldStart("run");
        write(json, figures.run());
        json.writeObjectFieldStart("shares");
        for (Map.Entry<Stage, Double> share : figures.shares().entrySet()) {
            Json.write(json, share.getKey().key(), share.getValue(), 4);
        }
        json.writeEndObject();
        json.writeNumberField("peak_heap_bytes", figures.peakHeapBytes());
        json.writeEndObject();
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, String part, Rates rates) throws IOException {
        json.writeObjectFieldStart(part);
        write(json, rates);
        json.writeEndObject();
    }

    private static void write(JsonGenerator json, Rates rates) throws IOException {
        json.writeNumberField("runs", rates.runs());
        Json.write(json, "min_events_per_s", rates.minPerS(), 1);
        Json.write(json, "median_events_per_s", rates.medianPerS(), 1);
        Json.write(json, "max_events_per_s", rates.maxPerS(), 1);
        Json.write(json, "median_ns_per_event", rates.medianNsPerEvent(), 3);
        Json.write(json, "median_cpu_ns_per_event", rates.cpuNsPerEvent(), 3);
        json.writeStringField("checksum", rates.checksum());
    }

    private static void write(JsonGenerator json, String packets, Latency latency) throws IOException {
        json.writeObjectFieldStart(packets);
        json.writeNumberField("packets", latency.packets());
        json.writeNumberField("p50_ns", latency.p50Ns());
        json.writeNumberField("p99_ns", latency.p99Ns());
        json.writeNumberField("p999_ns", latency.p999Ns());
        json.writeNumberField("max_ns", latency.maxNs());
        json.writeEndObject();
    }
}
