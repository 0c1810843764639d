package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;

/**
 * Reads text with one event per line. {@link TextLayout} finds the columns and the unit of time. Without header or
 * option, a line is {@code t x y p} as in the data sets of the Robotics and Perception Group, Zurich: t in seconds, x
 * right, y down, p 1 for ON and 0 (or -1) for OFF, separated by blanks, tabs or commas. Empty lines and lines that
 * start with {@code #} are skipped. Times are rounded to µs. Holds one file buffer.
 */
final class TextReader extends RecordingReader {
    /** Length limit of a line; a longer line is no event. */
    private static final int MAX_LINE_BYTES = 4096;
    private static final int SHOWN_CHARACTERS = 60;
    /** Limit of times, in s, so that µs fit into a long with room to spare: 31,000 years. */
    private static final BigDecimal MAX_SECONDS = BigDecimal.valueOf(1_000_000_000_000L);
    private static final int SECOND_DIGITS = 6;
    /** Number of digits of µs that surely fit into a long. */
    private static final int MAX_FAST_DIGITS = 18;
    private static final int MAX_INTEGER_DIGITS = 6;
    private static final String TRUE = "true";
    private static final String FALSE = "false";

    private final TextLayout layout;
    private final TextColumns columns;
    private final char separator;
    private final int unitDigits;
    private final boolean extraFields;
    private final int[] fieldAt;
    private final int[] fieldEnd;
    private long line;

    private TextReader(RecordingFile file, RecordingOptions options, TextLayout layout, ChipChoice choice) {
        super(file, options, "text", choice.name(), choice.sensor());
        this.layout = layout;
        columns = layout.columns();
        separator = layout.separator();
        unitDigits = layout.unit().digits;
        extraFields = options.columns() != null;
        fieldAt = new int[columns.count()];
        fieldEnd = new int[columns.count()];
        line = layout.headerLines();
        file.position += layout.bodyAt();
    }

    /** Finds the layout of the file and makes a reader at the first event. */
    static TextReader open(RecordingFile file, RecordingOptions options, ChipChoice choice)
            throws IOException, MalformedRecordingException {
        TextReader reader = new TextReader(file, options, TextLayout.of(file, options), choice);
        if (reader.layout.note() != null) {
            reader.addNote(reader.layout.note());
        }
        return reader;
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        int n = 0;
        try {
            while (n < batch.capacity()) {
                if (file.available() < MAX_LINE_BYTES && !file.require(MAX_LINE_BYTES) && file.available() == 0) {
                    return false;
                }
                n += decodeLine(batch, n);
            }
            return true;
        } finally {
            deliver(batch, n);
        }
    }

    /** Decodes one line and returns how many events it gave, 0 or 1. */
    private int decodeLine(EventBatch batch, int n) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int start = file.position;
        int limit = Math.min(file.limit, start + MAX_LINE_BYTES);
        int p = start;
        while (p < limit && buffer[p] != '\n') {
            p++;
        }
        boolean ends = p < limit;
        line++;
        if (!ends && limit < file.limit) {
            throw malformed(0, line, "malformed, a line must have less than " + MAX_LINE_BYTES + " bytes: "
                    + shown(start, p));
        }
        file.position = ends ? p + 1 : p;
        int fields = separator == 0 ? split(start, p) : splitBySeparator(start, p);
        if (fields == 0 || buffer[fieldAt[0]] == '#') {
            return 0;
        }
        if (fields < columns.count() || fields > columns.count() && !extraFields) {
            throw malformed(0, line, (ends ? "malformed" : "truncated")
                    + ", expected \"" + Printable.shortened(String.join(" ", columns.names()))
                    + "\" but found " + fields
                    + (fields == 1 ? " field: " : " fields: ") + shown(start, p));
        }
        long time = microseconds(start, p);
        int column = integer(columns.x(), "x", start, p);
        int row = integer(columns.y(), "y", start, p);
        int polarity = polarity(start, p);
        if (!sensor().contains(column, row)) {
            outside(column, row, 0, line);
            return 0;
        }
        note(n, line);
        batch.timeUs[n] = time;
        batch.x[n] = (short) column;
        batch.y[n] = (short) row;
        batch.polarity[n] = (byte) (polarity > 0 ? 1 : -1);
        return 1;
    }

    /** Finds the fields between blanks, tabs and commas, and returns how many there are. */
    private int split(int start, int end) {
        byte[] buffer = file.buffer;
        int most = fieldAt.length;
        int fields = 0;
        boolean inField = false;
        for (int p = start; p < end; p++) {
            byte next = buffer[p];
            boolean separates = next == ' ' || next == '\t' || next == ',' || next == '\r';
            if (separates && inField && fields <= most) {
                fieldEnd[fields - 1] = p;
            } else if (!separates && !inField) {
                if (fields < most) {
                    fieldAt[fields] = p;
                }
                fields++;
            }
            inField = !separates;
        }
        if (inField && fields <= most) {
            fieldEnd[fields - 1] = end;
        }
        return fields;
    }

    /** Finds the fields between separators, without the blanks around them; some may be empty. */
    private int splitBySeparator(int start, int end) {
        byte[] buffer = file.buffer;
        int fields = 0;
        int from = start;
        boolean isBlank = true;
        for (int p = start; p <= end; p++) {
            if (p == end || buffer[p] == separator) {
                if (fields < fieldAt.length) {
                    int first = from;
                    int last = p;
                    while (first < last && isBlank(buffer[first])) {
                        first++;
                    }
                    while (last > first && isBlank(buffer[last - 1])) {
                        last--;
                    }
                    fieldAt[fields] = first;
                    fieldEnd[fields] = last;
                }
                fields++;
                from = p + 1;
            }
            isBlank &= p == end || isBlank(buffer[p]);
        }
        return isBlank ? 0 : fields;
    }

    private static boolean isBlank(byte character) {
        return character == ' ' || character == '\t' || character == '\r' || character == '"';
    }

    /**
     * The time of the line in µs. It is computed without the rounding of a double, into which 1.4e9 s with 9 decimals
     * does not fit.
     */
    private long microseconds(int start, int end) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int p = fieldAt[columns.time()];
        int fieldEndAt = fieldEnd[columns.time()];
        boolean negative = p < fieldEndAt && buffer[p] == '-';
        if (negative) {
            p++;
        }
        long value = 0;
        int digits = 0;
        int mostDigits = MAX_FAST_DIGITS - Math.max(0, unitDigits);
        for (; p < fieldEndAt && isDigit(buffer[p]) && digits < mostDigits; p++, digits++) {
            value = 10 * value + buffer[p] - '0';
        }
        int decimals = 0;
        boolean roundUp = false;
        if (unitDigits >= 0 && p < fieldEndAt && buffer[p] == '.') {
            for (p++; p < fieldEndAt && isDigit(buffer[p]); p++, decimals++) {
                if (decimals < unitDigits) {
                    value = 10 * value + buffer[p] - '0';
                } else if (decimals == unitDigits) {
                    roundUp = buffer[p] >= '5';
                }
            }
        }
        if (p < fieldEndAt || digits + decimals == 0) {
            return unusualMicroseconds(start, end);
        }
        for (int i = decimals; i < unitDigits; i++) {
            value *= 10;
        }
        if (unitDigits < 0) {
            value = (value + 500) / 1000;
        }
        value += roundUp ? 1 : 0;
        return negative ? -value : value;
    }

    /** Reads times with an exponent and long ones, and refuses fields that are no number. */
    private long unusualMicroseconds(int start, int end) throws MalformedRecordingException {
        String text = text(fieldAt[columns.time()], fieldEnd[columns.time()]);
        try {
            BigDecimal seconds = new BigDecimal(text).scaleByPowerOfTen(unitDigits - SECOND_DIGITS);
            // An exponent of a billion would be expanded digit by digit, so magnitudes are compared first.
            if (seconds.precision() - (long) seconds.scale() > MAX_SECONDS.precision()
                    || seconds.abs().compareTo(MAX_SECONDS) >= 0) {
                throw malformed(0, line, "malformed, time must be smaller than " + MAX_SECONDS.toPlainString()
                        + " s but was " + Printable.shortened(text) + (unitDigits == SECOND_DIGITS ? ""
                        : " " + layout.unit()));
            }
            if (seconds.precision() - (long) seconds.scale() < -SECOND_DIGITS - 1) {
                return 0;
            }
            return seconds.movePointRight(SECOND_DIGITS).setScale(0, RoundingMode.HALF_UP).longValue();
        } catch (NumberFormatException | ArithmeticException e) {
            throw malformed(0, line, "malformed, time must be a number of " + (unitDigits == SECOND_DIGITS ? "seconds"
                    : layout.unit()) + ": " + shown(start, end));
        }
    }

    private int integer(int field, String name, int start, int end) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int p = fieldAt[field];
        int fieldEndAt = wholeEnd(p, fieldEnd[field]);
        boolean negative = p < fieldEndAt && buffer[p] == '-';
        if (negative) {
            p++;
        }
        int value = 0;
        // So few digits that no value overflows; no sensor has so many columns.
        boolean valid = p < fieldEndAt && fieldEndAt - p <= MAX_INTEGER_DIGITS;
        for (; valid && p < fieldEndAt; p++) {
            valid = isDigit(buffer[p]);
            value = 10 * value + buffer[p] - '0';
        }
        if (!valid) {
            throw malformed(0, line, "malformed, " + name + " must be an integer: " + shown(start, end));
        }
        return negative ? -value : value;
    }

    /** The end of a field without a fraction of zeros, which tables of floating-point numbers contain. */
    private int wholeEnd(int from, int end) {
        byte[] buffer = file.buffer;
        int p = end;
        while (p > from && buffer[p - 1] == '0') {
            p--;
        }
        return p > from && p < end && buffer[p - 1] == '.' ? p - 1 : end;
    }

    private int polarity(int start, int end) throws MalformedRecordingException {
        int from = fieldAt[columns.polarity()];
        int to = fieldEnd[columns.polarity()];
        if (to - from >= TRUE.length() && Character.isLetter(file.buffer[from])) {
            String word = text(from, to);
            if (word.equalsIgnoreCase(TRUE) || word.equalsIgnoreCase(FALSE)) {
                return word.equalsIgnoreCase(TRUE) ? 1 : 0;
            }
        }
        int polarity = integer(columns.polarity(), "polarity", start, end);
        if (polarity < -1 || polarity > 1) {
            throw malformed(0, line, "malformed, polarity must be 1, 0 or -1 but was " + polarity);
        }
        return polarity;
    }

    private static boolean isDigit(byte character) {
        return character >= '0' && character <= '9';
    }

    private String text(int from, int to) {
        return new String(file.buffer, from, to - from, StandardCharsets.ISO_8859_1);
    }

    /** Quotes a line for a message: a long line, or one that is not text at all, must not fill the screen. */
    private String shown(int start, int end) {
        String all = text(start, Math.min(end, start + SHOWN_CHARACTERS)).strip();
        return "\"" + Printable.of(all) + (end - start > SHOWN_CHARACTERS ? "..." : "") + "\"";
    }

    /** Names the line, because text has lines instead of bytes. */
    @Override
    String at(long event, long lineNumber) {
        return "[" + file.name + "] line " + lineNumber + ": ";
    }
}
