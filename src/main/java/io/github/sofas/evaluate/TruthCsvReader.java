package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.EventCsvReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads truth from a CSV file in step with the recording, and checks each line against its event. A truth file of
 * another recording is thus detected.
 *
 * <p>The first line names the columns {@value #HEADER}, in any order and possibly among other columns. One line follows
 * for each event of the recording whose truth is known, in order. Polarity is 1 or -1; object is 0 for noise. The two
 * velocities of noise may be empty.
 */
public final class TruthCsvReader implements Closeable {
    private static final String ID_COLUMN = "object";
    /** The first line in its usual form, without the line end. */
    public static final String HEADER = EventCsvReader.EVENT_COLUMNS + ID_COLUMN;

    private final EventCsvReader rows;

    private long[] timeUs = new long[1024];
    private float[] vxPxPerS = new float[1024];
    private float[] vyPxPerS = new float[1024];
    private int[] object = new int[1024];
    private int size;
    private long events;
    /** Whether the row read last still waits for its event; {@code expected} begins the message if none matches. */
    private boolean isWaiting;
    private String expected = "";

    private TruthCsvReader(EventCsvReader rows) {
        this.rows = rows;
    }

    /**
     * Opens a file and checks its first line.
     *
     * @param file the file
     * @return the reader
     * @throws TruthException if the first line lacks a column
     * @throws IOException if the file cannot be read
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
     * @param batch the next events of the recording
     * @param known is set to true for each event whose truth is in the file, and to false for the others
     * @throws TruthException if a line is malformed or belongs to another recording
     * @throws IOException if the file cannot be read
     */
    public void read(EventBatch batch, boolean[] known) throws TruthException, IOException {
        makeRoom(batch.size());
        try {
            for (int i = 0; i < batch.size(); i++) {
                known[i] = readRow(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
                events++;
            }
        } catch (EventSourceException e) {
            throw new TruthException(e.getMessage());
        }
    }

    /**
     * Reads the lines of the next events of the recording, each of which must have one.
     *
     * @param batch the next events of the recording
     * @throws TruthException if a line is missing or malformed, or belongs to another recording
     * @throws IOException if the file cannot be read
     */
    public void read(EventBatch batch) throws TruthException, IOException {
        boolean[] known = new boolean[batch.size()];
        read(batch, known);
        for (int i = 0; i < known.length; i++) {
            if (!known[i]) {
                throw new TruthException(rows.wrong("must be event " + (events - known.length + i)
                    + " of the recording (" + event(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i])
                    + ") but that has no line").getMessage());
            }
        }
    }

    /** Takes the row of an event; returns false if the file has no row for the event. */
    private boolean readRow(long time, int x, int y, int polarity) throws EventSourceException, IOException {
        if (!isWaiting) {
            isWaiting = rows.next();
            expected = isWaiting ? "must be event " + events + " of the recording ("
                + event(time, x, y, polarity) + ") or one after it but was (" : "";
        }
        if (!isWaiting) {
            return false;
        }
        if (rows.timeUs() != time || rows.x() != x || rows.y() != y || rows.polarity() != polarity) {
            if (rows.timeUs() < time) {
                throw notMet();
            }
            return false;
        }
        isWaiting = false;
        if (rows.id() != GroundTruth.NOISE) {
            rows.requireVelocity();
        }
        timeUs[size] = time;
        vxPxPerS[size] = rows.vxPxPerS();
        vyPxPerS[size] = rows.vyPxPerS();
        object[size] = rows.id();
        size++;
        return true;
    }

    private EventSourceException notMet() {
        return rows.wrong(expected + event(rows.timeUs(), rows.x(), rows.y(), rows.polarity()) + ")");
    }

    /**
     * Checks that the file ends together with the recording.
     *
     * @throws TruthException if the file has further lines
     * @throws IOException if the file cannot be read
     */
    public void end() throws TruthException, IOException {
        try {
            if (isWaiting) {
                throw notMet();
            }
            if (rows.next()) {
                throw rows.wrong("must not be there, as the recording has " + events + " events, but was "
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
