package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.export.FlowCsvWriter;
import io.github.sofas.export.SegmentsCsv;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Flow and segments as the runner writes them: columns, digits and axes. */
record CsvFiles(byte[] flow, byte[] segments) {

    /** Takes down what is there now. */
    static CsvFiles of(EventBatch batch, FlowOutput output, List<Segment> living) {
        ByteArrayOutputStream flow = new ByteArrayOutputStream();
        ByteArrayOutputStream segments = new ByteArrayOutputStream();
        try (FlowCsvWriter writer = new FlowCsvWriter(flow)) {
            writer.write(batch, output);
            SegmentsCsv.write(segments, living);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new CsvFiles(flow.toByteArray(), segments.toByteArray());
    }

    /**
     * Writes NAME.flow.csv and NAME.segments.csv.
     *
     * @return what was done, for the log
     */
    String write(Path name) throws IOException {
        Path flowFile = name.resolveSibling(name.getFileName() + ".flow.csv");
        Path segmentsFile = name.resolveSibling(name.getFileName() + ".segments.csv");
        Files.write(flowFile, flow);
        Files.write(segmentsFile, segments);
        return "SOFAS wrote " + flowFile + " and " + segmentsFile;
    }
}
