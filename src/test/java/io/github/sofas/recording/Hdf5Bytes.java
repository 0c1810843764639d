package io.github.sofas.recording;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.DatasetCreationOptions;
import io.jhdf.api.WritableGroup;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;

/** HDF5 files as data sets lay them out, small and valid by default. */
final class Hdf5Bytes {
    private Hdf5Bytes() {
    }

    /** A file that is filled by the caller. */
    static byte[] of(Consumer<WritableHdfFile> content) {
        try {
            Path file = Files.createTempFile("sofas", ".h5");
            try {
                Files.delete(file);
                try (WritableHdfFile hdf = HdfFile.write(file)) {
                    content.accept(hdf);
                }
                return Files.readAllBytes(file);
            } finally {
                Files.deleteIfExists(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Data sets of one column each, in chunks of two events where that is asked. */
    static void columns(WritableGroup events, boolean isChunked) {
        DatasetCreationOptions options = isChunked
            ? DatasetCreationOptions.builder().chunkDimensions(2).deflate(6).build() : DatasetCreationOptions.DEFAULT;
        events.putDataset("x", new short[] {0, 15, 3, 4, 5}, options);
        events.putDataset("y", new short[] {0, 11, 4, 5, 6}, options);
        events.putDataset("p", new byte[] {1, 0, 1, 0, 1}, options);
        events.putDataset("t", new int[] {10, 12, 13, 13, 20}, options);
    }

    /** DSEC's layout. */
    static byte[] dsec(boolean isChunked) {
        return of(hdf -> {
            columns(hdf.putGroup("events"), isChunked);
            hdf.putDataset("t_offset", new long[] {1_000_000_000_000L});
            hdf.putAttribute("width", 16);
            hdf.putAttribute("height", 12);
        });
    }

    /** MVSEC's layout: x, y, t in s, p. */
    static byte[] mvsec() {
        return of(hdf -> hdf.putGroup("davis").putGroup("left").putDataset("events", new double[][] {
            {0, 0, 1506117892.000001, 1}, {15, 11, 1506117892.000003, -1}}));
    }
}
