package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.EventCsvReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads truth from a CSV file beside its recording and holds each line against the event that it belongs to.
 *
 * <p>The first line is {@value #HEADER}; then comes one line for every event of the recording, in order. Polarity is 1
 * or -1, object 0 for noise. The two velocities of noise may be empty.
 */
public final class TruthCsvReader implements Closeable {
    private static final String ID_COLUMN = "object";
    /** The first line, without its end. */
    public static final String HEADER = EventCsvReader.EVENT_COLUMNS + ID_COLUMN;

    private final EventCsvReader rows;

    private long[] timeUs = new long[1024];
    private float[] vxPxPerS = new float[1024];
    private float[] vyPxPerS = new float[1024];
    private int[] object = new int[1024];
    private int size;

    private TruthCsvReader(EventCsvReader rows) {
        this.rows = rows;
    }

    /**
     * Opens a file and checks its first line.
     *
     * @param file the file
     * @return the reader
     * @throws TruthException where that is another
     * @throws IOException where it cannot be read
     */
    public static TruthCsvReader open(Path file) throws TruthException, IOException {
        try {
            return new TruthCsvReader(EventCsvReader.open(file, ID_COLUMN));
        } catch (EventSourceException e) {
            throw new TruthException(e.getMessage());
        }
    }

    /**
     * Reads the lines of the next events of the recording.
     *
     * @param batch the events whose truth comes next in the file
     * @throws TruthException where a line is missing, malformed or of another event
     * @throws IOException where the file cannot be read
     */
    public void read(EventBatch batch) throws TruthException, IOException {
        makeRoom(batch.size());
        try {
            for (int i = 0; i < batch.size(); i++) {
                readRow(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
            }
        } catch (EventSourceException e) {
            throw new TruthException(e.getMessage());
        }
    }

    private void readRow(long time, int x, int y, int polarity) throws EventSourceException, IOException {
        if (!rows.next()) {
            throw rows.wrong("must be event " + size + " of the recording (" + event(time, x, y, polarity)
                + ") but the file ends");
        }
        if (rows.timeUs() != time || rows.x() != x || rows.y() != y || rows.polarity() != polarity) {
            throw rows.wrong("must be event " + size + " of the recording (" + event(time, x, y, polarity)
                + ") but was (" + event(rows.timeUs(), rows.x(), rows.y(), rows.polarity()) + ")");
        }
        if (rows.id() != GroundTruth.NOISE) {
            rows.requireVelocity();
        }
        timeUs[size] = time;
        vxPxPerS[size] = rows.vxPxPerS();
        vyPxPerS[size] = rows.vyPxPerS();
        object[size] = rows.id();
        size++;
    }

    /**
     * Says that the recording has ended.
     *
     * @throws TruthException where the file goes on
     * @throws IOException where it cannot be read
     */
    public void end() throws TruthException, IOException {
        try {
            if (rows.next()) {
                throw rows.wrong("must not be there, as the recording has " + size + " events, but was "
                    + rows.quotedLine());
            }
        } catch (EventSourceException e) {
            throw new TruthException(e.getMessage());
        }
    }

    /** {@return the truth of the events read so far} */
    public GroundTruth truth() {
        return new GroundTruth(Arrays.copyOf(timeUs, size), Arrays.copyOf(vxPxPerS, size),
                Arrays.copyOf(vyPxPerS, size), Arrays.copyOf(object, size));
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }

    private void makeRoom(int more) {
        if (size + more > timeUs.length) {
            int capacity = Math.max(size + more, size + (size >> 1));
            timeUs = Arrays.copyOf(timeUs, capacity);
            vxPxPerS = Arrays.copyOf(vxPxPerS, capacity);
            vyPxPerS = Arrays.copyOf(vyPxPerS, capacity);
            object = Arrays.copyOf(object, capacity);
        }
    }

    private static String event(long time, int x, int y, int polarity) {
        return "t_us " + time + ", x " + x + ", y " + y + ", polarity " + polarity;
    }
}
