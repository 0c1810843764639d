package io.github.sofas.export;

import static io.github.sofas.FuzzRules.require;

import io.github.sofas.FuzzRules;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.FlowOutput;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Files of labels, whatever is in them: rows that make sense, then an end or one exception. */
public final class FlowCsvFuzz {
    private static final Path FILE = FuzzRules.file(".flow.csv");
    private static final int BATCH = 16;
    private static final int LONGEST_MESSAGE = 500;

    private FlowCsvFuzz() {
    }

    /** Called by the fuzzer. */
    public static void fuzzerTestOneInput(byte[] data) {
        FuzzRules.write(FILE, data);
        try (FlowCsvReader reader = FlowCsvReader.open(FILE)) {
            drain(reader);
        } catch (EventSourceException e) {
            checkMessage(e.getMessage());
        }
    }

    private static void drain(FlowCsvReader reader) throws EventSourceException {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput flow = new FlowOutput(BATCH);
        try {
            while (reader.next(batch, flow)) {
                for (int i = 0; i < batch.size(); i++) {
                    require(batch.x[i] >= 0 && batch.y[i] >= 0, "a pixel is negative");
                    require(Math.abs(batch.polarity[i]) == 1, "a polarity is neither 1 nor -1");
                    require(Float.isFinite(flow.vxPxPerS[i]) && Float.isFinite(flow.vyPxPerS[i]), "not finite");
                    require(flow.segment[i] >= 0, "a segment is negative");
                }
            }
        } catch (EventSourceException e) {
            try {
                reader.next(batch, flow);
                throw new IllegalStateException("goes on after damage");
            } catch (EventSourceException again) {
                require(again == e, "says another thing when asked again");
            }
            throw e;
        }
    }

    private static void checkMessage(String message) {
        FuzzRules.checkMessage(message, "[" + FILE.getFileName() + "] line ", LONGEST_MESSAGE);
    }

    /** Valid inputs to start from. */
    public static List<byte[]> seeds() {
        String rows = "-5,0,0,1,,,0\n10,239,179,-1,-12.5,0.25,7\n9007199254740992,32767,1,1,1500,-0,2147483647\n";
        return List.of((FlowCsvWriter.HEADER + "\n" + rows).getBytes(StandardCharsets.US_ASCII));
    }
}
