package io.github.sofas.evaluate;

import static io.github.sofas.FuzzRules.require;

import io.github.sofas.FuzzRules;
import io.github.sofas.event.EventBatch;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Files of truth, whatever is in them, held against three events: the truth of these, or one exception. */
public final class TruthCsvFuzz {
    private static final Path FILE = FuzzRules.file(".truth.csv");
    private static final int LONGEST_MESSAGE = 500;

    private TruthCsvFuzz() {
    }

    /** Called by the fuzzer. */
    public static void fuzzerTestOneInput(byte[] data) {
        EventBatch batch = new EventBatch(3);
        batch.add(-5, 0, 0, 1);
        batch.add(10, 239, 179, -1);
        batch.add(1_000_000_000_000L, 3, 4, 1);
        FuzzRules.write(FILE, data);
        try (TruthCsvReader reader = TruthCsvReader.open(FILE)) {
            reader.read(batch);
            reader.end();
            check(reader.truth());
        } catch (TruthException e) {
            checkMessage(e.getMessage());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void check(GroundTruth truth) {
        require(truth.size() == 3, "not the truth of all events");
        for (int i = 0; i < truth.size(); i++) {
            require(Float.isFinite(truth.vxPxPerS()[i]) && Float.isFinite(truth.vyPxPerS()[i]), "not finite");
            require(truth.object()[i] >= 0, "an object is negative");
        }
    }

    private static void checkMessage(String message) {
        FuzzRules.checkMessage(message, "[" + FILE.getFileName() + "] line ", LONGEST_MESSAGE);
    }

    /** Valid inputs to start from. */
    public static List<byte[]> seeds() {
        String rows = "-5,0,0,1,-1e3,.5,1\n10,239,179,-1,,,0\r\n1000000000000,3,4,1,0,-0,2147483647";
        return List.of((TruthCsvReader.HEADER + "\n" + rows).getBytes(StandardCharsets.US_ASCII));
    }
}
