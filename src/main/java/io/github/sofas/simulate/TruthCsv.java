package io.github.sofas.simulate;

import io.github.sofas.event.EventBatch;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes the truth of every event as a CSV row {@value #HEADER}. Velocities have three decimals, rounded half away from
 * zero. For noise, both velocity fields are empty and the object is 0. Lines end in LF.
 */
public final class TruthCsv implements Closeable {
    /** The first line, without its end. */
    public static final String HEADER = "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object";

    private static final int FLUSH_CHARS = 1 << 15;

    private final BufferedWriter out;
    private final StringBuilder text = new StringBuilder(FLUSH_CHARS + 128);

    /**
     * Creates or replaces the file and writes the header.
     *
     * @param path the file to write; replaced if it exists
     * @throws IOException if it cannot be written
     */
    public TruthCsv(Path path) throws IOException {
        this(Files.newOutputStream(path));
    }

    /**
     * Writes the header to a stream.
     *
     * @param stream closed by {@link #close()}; needs no buffer
     */
    public TruthCsv(OutputStream stream) {
        out = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.US_ASCII));
        text.append(HEADER).append('\n');
    }

    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @param truth the truth that was filled together with the batch
     * @throws IOException if they cannot be written
     */
    public void write(EventBatch batch, Truth truth) throws IOException {
        for (int i = 0; i < batch.size(); i++) {
            row(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i], truth.vxPxPerS[i], truth.vyPxPerS[i],
                    truth.object[i]);
        }
    }

    /**
     * Writes the rows of a whole recording.
     *
     * @param recording the recording
     * @throws IOException if they cannot be written
     */
    public void write(SimulatedRecording recording) throws IOException {
        for (int i = 0; i < recording.size(); i++) {
            row(recording.timeUs[i], recording.x[i], recording.y[i], recording.polarity[i], recording.vxPxPerS[i],
                    recording.vyPxPerS[i], recording.object[i]);
        }
    }

    private void row(long timeUs, int x, int y, int polarity, float vx, float vy, int object) throws IOException {
        text.append(timeUs).append(',').append(x).append(',').append(y).append(',').append(polarity).append(',');
        if (object != 0) {
            appendThousandths(vx);
        }
        text.append(',');
        if (object != 0) {
            appendThousandths(vy);
        }
        text.append(',').append(object).append('\n');
        if (text.length() > FLUSH_CHARS) {
            out.append(text);
            text.setLength(0);
        }
    }

    /** The product of a float and 1000 is exact as a double, so that the float's exact value is rounded. */
    private void appendThousandths(float velocity) {
        long thousandths = Math.round(Math.abs((double) velocity) * 1000);
        if (velocity < 0 && thousandths > 0) {
            text.append('-');
        }
        text.append(thousandths / 1000).append('.');
        long rest = thousandths % 1000;
        text.append((char) ('0' + rest / 100)).append((char) ('0' + rest / 10 % 10)).append((char) ('0' + rest % 10));
    }

    /** Writes what is still buffered and closes the file. */
    @Override
    public void close() throws IOException {
        try (out) {
            out.append(text);
            text.setLength(0);
        }
    }
}
