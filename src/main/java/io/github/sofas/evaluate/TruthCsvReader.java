package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * Reads truth from a CSV file beside its recording and holds each line against the event that it belongs to.
 *
 * <p>The first line is {@value #HEADER}; then comes one line for every event of the recording, in order. Polarity is 1
 * or -1, object 0 for noise. The two velocities of noise may be empty.
 */
public final class TruthCsvReader implements Closeable {
    /** The first line, without its end. */
    public static final String HEADER = "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object";

    private static final String[] COLUMNS = HEADER.split(",");
    private static final int MOST_CHARACTERS = 1000;
    private static final int VX = 4;
    private static final int OBJECT = 6;

    private final String name;
    private final BufferedReader in;
    private long line = 1;
    private final String[] fields = new String[COLUMNS.length];

    private long[] timeUs = new long[1024];
    private float[] vxPxPerS = new float[1024];
    private float[] vyPxPerS = new float[1024];
    private int[] object = new int[1024];
    private int size;

    private TruthCsvReader(Path file, BufferedReader in) {
        name = String.valueOf(file.getFileName());
        this.in = in;
    }

    /**
     * Opens a file and checks its first line.
     *
     * @throws TruthException where that is another
     * @throws IOException where it cannot be read
     */
    public static TruthCsvReader open(Path file) throws TruthException, IOException {
        // Every byte is a character here, so that a binary file is refused for its first line, not for its encoding.
        TruthCsvReader reader = new TruthCsvReader(file, Files.newBufferedReader(file, StandardCharsets.ISO_8859_1));
        try {
            String first = reader.readLine();
            if (!HEADER.equals(first)) {
                throw reader.wrong("must be \"" + HEADER + "\" but " + (first == null ? "the file is empty"
                        : "was " + quoted(first)));
            }
            return reader;
        } catch (TruthException | IOException e) {
            reader.close();
            throw e;
        }
    }

    /**
     * Reads the lines of the next events of the recording.
     *
     * @throws TruthException where a line is missing, malformed or of another event
     * @throws IOException where the file cannot be read
     */
    public void read(EventBatch batch) throws TruthException, IOException {
        makeRoom(batch.size());
        for (int i = 0; i < batch.size(); i++) {
            line++;
            String text = readLine();
            if (text == null) {
                throw wrong("must be event " + size + " of the recording (" + event(batch.timeUs[i], batch.x[i],
                        batch.y[i], batch.polarity[i]) + ") but the file ends");
            }
            split(text);
            long time = whole(0);
            long x = whole(1);
            long y = whole(2);
            long polarity = whole(3);
            if (time != batch.timeUs[i] || x != batch.x[i] || y != batch.y[i] || polarity != batch.polarity[i]) {
                throw wrong("must be event " + size + " of the recording (" + event(batch.timeUs[i], batch.x[i],
                        batch.y[i], batch.polarity[i]) + ") but was (" + event(time, x, y, polarity) + ")");
            }
            long cause = whole(OBJECT);
            if (cause < 0 || cause > Integer.MAX_VALUE) {
                throw wrong("object must be between 0 and " + Integer.MAX_VALUE + " but was " + cause);
            }
            boolean noise = cause == GroundTruth.NOISE;
            timeUs[size] = time;
            vxPxPerS[size] = velocity(VX, noise);
            vyPxPerS[size] = velocity(VX + 1, noise);
            object[size] = (int) cause;
            size++;
        }
    }

    /**
     * Says that the recording has ended.
     *
     * @throws TruthException where the file goes on
     * @throws IOException where it cannot be read
     */
    public void end() throws TruthException, IOException {
        line++;
        String text = readLine();
        if (text != null) {
            throw wrong("must not be there, as the recording has " + size + " events, but was " + quoted(text));
        }
    }

    /** The truth of the events read so far. */
    public GroundTruth truth() {
        return new GroundTruth(Arrays.copyOf(timeUs, size), Arrays.copyOf(vxPxPerS, size),
                Arrays.copyOf(vyPxPerS, size), Arrays.copyOf(object, size));
    }

    @Override
    public void close() throws IOException {
        in.close();
    }

    /** The next line, at most so long that what is no text takes no memory; null at the end. */
    private String readLine() throws TruthException, IOException {
        StringBuilder text = new StringBuilder();
        int c = in.read();
        if (c < 0) {
            return null;
        }
        for (; c >= 0 && c != '\n'; c = in.read()) {
            if (text.length() == MOST_CHARACTERS) {
                throw wrong("must have at most " + MOST_CHARACTERS + " characters but begins with " + quoted(
                    text.toString()));
            }
            text.append((char) c);
        }
        int last = text.length() - 1;
        return last >= 0 && text.charAt(last) == '\r' ? text.substring(0, last) : text.toString();
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

    private void split(String text) throws TruthException {
        int count = 0;
        int from = 0;
        while (count < fields.length) {
            int comma = text.indexOf(',', from);
            fields[count++] = text.substring(from, comma < 0 ? text.length() : comma);
            if (comma < 0) {
                from = -1;
                break;
            }
            from = comma + 1;
        }
        if (count < fields.length || from >= 0) {
            throw wrong("must have " + COLUMNS.length + " fields, " + HEADER + ", but was " + quoted(text));
        }
    }

    private long whole(int column) throws TruthException {
        try {
            return Long.parseLong(fields[column]);
        } catch (NumberFormatException e) {
            throw wrong(COLUMNS[column] + " must be a whole number but was " + quoted(fields[column]));
        }
    }

    private float velocity(int column, boolean noise) throws TruthException {
        if (noise && fields[column].isEmpty()) {
            return 0;
        }
        try {
            float value = Float.parseFloat(fields[column]);
            if (Float.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw notFinite(column);
        }
        // Words like Infinity, which the language takes for numbers.
        throw notFinite(column);
    }

    private TruthException notFinite(int column) {
        return wrong(COLUMNS[column] + " must be a finite number but was " + quoted(fields[column]));
    }

    private static String event(long time, long x, long y, long polarity) {
        return "t_us " + time + ", x " + x + ", y " + y + ", polarity " + polarity;
    }

    /** Long or binary text is cut so that a message stays one line of a terminal. */
    private static String quoted(String text) {
        String printable = text.replaceAll("[^ -~]", "?");
        return '"' + (printable.length() > 100 ? printable.substring(0, 100) + "..." : printable) + '"';
    }

    private TruthException wrong(String what) {
        return new TruthException("[" + name + "] line " + line + ": " + what);
    }
}
