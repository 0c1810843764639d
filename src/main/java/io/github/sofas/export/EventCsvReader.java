package io.github.sofas.export;

import io.github.sofas.event.EventSourceException;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/**
 * Reads the lines of flow files and of truth files, which have the same form: an event, its velocity, and an id. The
 * name of the last column determines whether the id is that of a segment or of an object. Holds one buffer.
 */
public final class EventCsvReader implements Closeable {
    /** Beginning of the first line; the name of the last column follows. */
    public static final String EVENT_COLUMNS = "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,";
    private static final int TIME = 0;
    private static final int X = 1;
    private static final int Y = 2;
    private static final int POLARITY = 3;
    private static final int VX = 4;
    private static final int VY = 5;
    private static final int ID = 6;
    /**
     * Most characters of a line. A file that is not text may have no line ends, and must not take more and more memory.
     */
    private static final int MOST_CHARACTERS = 1000;
    private static final int BUFFER = 1 << 16;
    private static final int MOST_DIGITS = 18;
    private static final double[] POWERS = new double[MOST_DIGITS + 1];
    /** Greatest time: 18 digits, which are 31,700 years and more than any recording holds. */
    private static final long MOST_US = 999_999_999_999_999_999L;

    static {
        POWERS[0] = 1;
        for (int i = 1; i < POWERS.length; i++) {
            POWERS[i] = POWERS[i - 1] * 10;
        }
    }

    private final String name;
    private final String header;
    private final String[] columns;
    private final InputStream in;
    private final byte[] buffer = new byte[BUFFER];
    private int position;
    private int limit;
    private long line;
    // the line read last: where it begins and ends, whether it has a line end, and where each field begins
    private int start;
    private int end;
    private boolean ended;
    private int[] from = new int[ID + 2];
    /** Index of the field that belongs to each column. */
    private final int[] field = {TIME, X, Y, POLARITY, VX, VY, ID};
    private int fields = ID + 1;

    private long timeUs;
    private int x;
    private int y;
    private int polarity;
    private float vxPxPerS;
    private float vyPxPerS;
    private int id;

    private EventCsvReader(Path file, String idColumn, InputStream in) {
        name = String.valueOf(file.getFileName());
        header = EVENT_COLUMNS + idColumn;
        columns = header.split(",");
        this.in = in;
    }

    /**
     * Opens a file and finds its columns by the names in its first line. They may be in any order and among others.
     *
     * @param file the file
     * @param idColumn name of the last column
     * @return the reader
     * @throws EventSourceException if a column is missing
     * @throws IOException if the file cannot be read
     */
    public static EventCsvReader open(Path file, String idColumn) throws EventSourceException, IOException {
        EventCsvReader reader = new EventCsvReader(file, idColumn, Files.newInputStream(file));
        try {
            boolean empty = !reader.readLine();
            if (empty || !reader.findColumns(reader.text(reader.start, reader.end))) {
                throw reader.wrong("must be \"" + reader.header + "\" but "
                    + (empty ? "the file is empty" : "was " + reader.quotedLine()));
            }
            return reader;
        } catch (EventSourceException | IOException e) {
            reader.close();
            throw e;
        }
    }

    /** Finds the columns in a first line, in any order and among others. Returns false if one is missing. */
    private boolean findColumns(String first) {
        List<String> names = Arrays.asList(first.split(",", -1));
        for (int column = 0; column < columns.length; column++) {
            field[column] = names.indexOf(columns[column]);
            if (field[column] < 0) {
                return false;
            }
        }
        fields = names.size();
        from = new int[fields + 1];
        return true;
    }

    /**
     * Reads the next line.
     *
     * @return false at the end
     * @throws EventSourceException if the line is malformed
     * @throws IOException if the file cannot be read
     */
    public boolean next() throws EventSourceException, IOException {
        if (!readLine()) {
            return false;
        }
        split();
        timeUs = whole(TIME, -MOST_US, MOST_US);
        x = (int) whole(X, 0, Short.MAX_VALUE);
        y = (int) whole(Y, 0, Short.MAX_VALUE);
        polarity = (int) whole(POLARITY, -1, 1);
        if (polarity == 0) {
            throw mustBe(POLARITY, "1 or -1");
        }
        vxPxPerS = number(VX);
        vyPxPerS = number(VY);
        id = (int) whole(ID, 0, Integer.MAX_VALUE);
        return true;
    }

    /** {@return the time of the event in µs} */
    public long timeUs() {
        return timeUs;
    }

    /** {@return the column of the event} */
    public int x() {
        return x;
    }

    /** {@return the row of the event} */
    public int y() {
        return y;
    }

    /** {@return the polarity of the event, 1 or -1} */
    public int polarity() {
        return polarity;
    }

    /** {@return the velocity to the right in px/s; 0 if the field is empty} */
    public float vxPxPerS() {
        return vxPxPerS;
    }

    /** {@return the velocity downwards in px/s; 0 if the field is empty} */
    public float vyPxPerS() {
        return vyPxPerS;
    }

    /** {@return the number in the last column, at least 0} */
    public int id() {
        return id;
    }

    /**
     * Checks that the event has a velocity.
     *
     * @throws EventSourceException if a component is empty
     */
    public void requireVelocity() throws EventSourceException {
        for (int column = VX; column <= VY; column++) {
            if (length(column) == 0) {
                throw mustBe(column, "a finite number");
            }
        }
    }

    /**
     * Checks that the line read last has a line end. If a file was cut off, its last line has none.
     *
     * @throws EventSourceException if the line has none
     */
    public void requireLineEnd() throws EventSourceException {
        if (!ended) {
            throw wrong("must end with a new line but was " + quotedLine());
        }
    }

    /**
     * {@return an exception about the line read last, or about one that is missing}
     *
     * @param what the rule and the value
     */
    public EventSourceException wrong(String what) {
        return new EventSourceException("[" + name + "] line " + line + ": " + what);
    }

    /** {@return the line read last, in quotes, cut so that a message stays one line of a terminal} */
    public String quotedLine() {
        return quoted(start, end);
    }

    private String quoted(int first, int after) {
        String printable = text(first, after).replaceAll("[^ -~]", "?");
        return '"' + (printable.length() > 100 ? printable.substring(0, 100) + "..." : printable) + '"';
    }

    /**
     * Takes every byte as a character, so that a binary file is refused for its first line and not for its encoding.
     */
    private String text(int first, int after) {
        return new String(buffer, first, after - first, StandardCharsets.ISO_8859_1);
    }

    private boolean readLine() throws EventSourceException, IOException {
        line++;
        int length = 0;
        do {
            while (position + length < limit && buffer[position + length] != '\n' && length <= MOST_CHARACTERS) {
                length++;
            }
            ended = position + length < limit && buffer[position + length] == '\n';
        } while (!ended && length <= MOST_CHARACTERS && fill());
        start = position;
        end = start + length;
        if (length > MOST_CHARACTERS) {
            throw wrong("must have at most " + MOST_CHARACTERS + " characters but begins with " + quotedLine());
        }
        position = ended ? end + 1 : end;
        if (end > start && buffer[end - 1] == '\r') {
            end--;
        }
        return ended || position > start;
    }

    /** Moves the unread bytes to the front of the buffer and reads on. Returns false at the end of the file. */
    private boolean fill() throws IOException {
        System.arraycopy(buffer, position, buffer, 0, limit - position);
        limit -= position;
        position = 0;
        int more = in.read(buffer, limit, buffer.length - limit);
        limit += Math.max(0, more);
        return more > 0;
    }

    private void split() throws EventSourceException {
        int count = 0;
        from[count++] = start;
        for (int i = start; i < end; i++) {
            if (buffer[i] == ',') {
                if (count == fields) {
                    count++;
                    break;
                }
                from[count++] = i + 1;
            }
        }
        if (count != fields) {
            throw wrong("must have " + fields + " fields" + (fields == columns.length ? ", " + header + "," : "")
                + " but was " + quotedLine());
        }
        from[count] = end + 1;
    }

    private int from(int column) {
        return from[field[column]];
    }

    private int after(int column) {
        return from[field[column] + 1] - 1;
    }

    private int length(int column) {
        return after(column) - from(column);
    }

    private long whole(int column, long least, long most) throws EventSourceException {
        int after = after(column);
        int i = from(column);
        boolean negative = i < after && buffer[i] == '-';
        i += negative ? 1 : 0;
        long value = 0;
        boolean valid = i < after && after - i <= MOST_DIGITS;
        for (; valid && i < after; i++) {
            int digit = buffer[i] - '0';
            valid = digit >= 0 && digit <= 9;
            value = value * 10 + digit;
        }
        value = negative ? -value : value;
        if (!valid || value < least || value > most) {
            throw mustBe(column, "a whole number from " + least + " to " + most);
        }
        return value;
    }

    private float number(int column) throws EventSourceException {
        int after = after(column);
        int i = from(column);
        boolean negative = i < after && buffer[i] == '-';
        i += negative ? 1 : 0;
        long value = 0;
        int digits = 0;
        int decimals = 0;
        boolean point = false;
        if (after - i > MOST_DIGITS) {
            return unusual(column);
        }
        for (; i < after; i++) {
            int digit = buffer[i] - '0';
            if (digit >= 0 && digit <= 9) {
                value = value * 10 + digit;
                digits++;
                decimals += point ? 1 : 0;
            } else if (buffer[i] == '.' && !point) {
                point = true;
            } else {
                return unusual(column);
            }
        }
        if (digits == 0 && length(column) > 0) {
            throw mustBe(column, "a finite number");
        }
        double magnitude = value / POWERS[decimals];
        return (float) (negative ? -magnitude : magnitude);
    }

    /** Parses a number with an exponent or with many digits, but none of the words that Java accepts as numbers. */
    private float unusual(int column) throws EventSourceException {
        String text = text(from(column), after(column));
        if (text.matches("[-+]?[0-9]*\\.?[0-9]*([eE][-+]?[0-9]+)?") && text.matches(".*[0-9].*")) {
            try {
                float value = Float.parseFloat(text);
                if (Float.isFinite(value)) {
                    return value;
                }
            } catch (NumberFormatException e) {
                throw mustBe(column, "a finite number");
            }
        }
        throw mustBe(column, "a finite number");
    }

    private EventSourceException mustBe(int column, String rule) {
        return wrong(columns[column] + " must be " + rule + " but was " + quoted(from(column), after(column)));
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
