package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;

/**
 * Reads text: one event a line, {@code t x y p}, with t in seconds, x right, y down, p 1 for ON and 0 (or -1) for OFF,
 * separated by blanks, tabs or commas (the data sets of the Robotics and Perception Group, Zurich). Empty lines and
 * lines that start with {@code #} are passed over. Times are rounded to µs. Holds one file buffer.
 */
final class TextReader extends RecordingReader {
    /** Of any line; one that is longer is no event. */
    private static final int MAX_LINE_BYTES = 4096;
    private static final int FIELDS = 4;
    private static final int SHOWN_CHARACTERS = 60;
    /** So that µs fit into a long with room to spare: 31,000 years. */
    private static final BigDecimal MAX_SECONDS = BigDecimal.valueOf(1_000_000_000_000L);
    private static final int FRACTION_DIGITS = 6;
    private static final int MAX_FAST_DIGITS = 12;

    private final int[] fieldAt = new int[FIELDS];
    private final int[] fieldEnd = new int[FIELDS];
    private long line;

    TextReader(RecordingFile file, RecordingOptions options, ChipChoice choice) {
        super(file, options, "text", choice.name(), choice.sensor());
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
        int fields = 0;
        boolean inField = false;
        int p = start;
        for (; p < limit && buffer[p] != '\n'; p++) {
            byte next = buffer[p];
            boolean separates = next == ' ' || next == '\t' || next == ',' || next == '\r';
            if (separates && inField && fields <= FIELDS) {
                fieldEnd[fields - 1] = p;
            } else if (!separates && !inField) {
                if (fields < FIELDS) {
                    fieldAt[fields] = p;
                }
                fields++;
            }
            inField = !separates;
        }
        if (inField && fields <= FIELDS) {
            fieldEnd[fields - 1] = p;
        }
        boolean ends = p < limit;
        line++;
        if (!ends && limit < file.limit) {
            throw malformed(0, line, "malformed, a line must have less than " + MAX_LINE_BYTES + " bytes: "
                    + shown(start, p));
        }
        file.position = ends ? p + 1 : p;
        if (fields == 0 || buffer[fieldAt[0]] == '#') {
            return 0;
        }
        if (fields != FIELDS) {
            throw malformed(0, line, (ends ? "malformed" : "truncated")
                    + ", expected \"t x y polarity\" but found " + fields
                    + (fields == 1 ? " field: " : " fields: ") + shown(start, p));
        }
        long time = microseconds(start, p);
        int column = integer(1, "x", start, p);
        int row = integer(2, "y", start, p);
        int polarity = integer(3, "polarity", start, p);
        if (polarity < -1 || polarity > 1) {
            throw malformed(0, line, "malformed, polarity must be 1, 0 or -1 but was " + polarity);
        }
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

    /** The time of the line, without the rounding of a double: 1.4e9 s with 9 decimals does not fit into one. */
    private long microseconds(int start, int end) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int p = fieldAt[0];
        int fieldEndAt = fieldEnd[0];
        boolean negative = buffer[p] == '-';
        if (negative) {
            p++;
        }
        long value = 0;
        int digits = 0;
        for (; p < fieldEndAt && isDigit(buffer[p]) && digits < MAX_FAST_DIGITS; p++, digits++) {
            value = 10 * value + buffer[p] - '0';
        }
        int decimals = 0;
        boolean roundUp = false;
        if (p < fieldEndAt && buffer[p] == '.') {
            for (p++; p < fieldEndAt && isDigit(buffer[p]); p++, decimals++) {
                if (decimals < FRACTION_DIGITS) {
                    value = 10 * value + buffer[p] - '0';
                } else if (decimals == FRACTION_DIGITS) {
                    roundUp = buffer[p] >= '5';
                }
            }
        }
        if (p < fieldEndAt || digits + decimals == 0) {
            return unusualMicroseconds(start, end);
        }
        for (int i = decimals; i < FRACTION_DIGITS; i++) {
            value *= 10;
        }
        value += roundUp ? 1 : 0;
        return negative ? -value : value;
    }

    /** Times with an exponent, and what is no number. */
    private long unusualMicroseconds(int start, int end) throws MalformedRecordingException {
        String text = text(fieldAt[0], fieldEnd[0]);
        try {
            BigDecimal seconds = new BigDecimal(text);
            // An exponent of a billion would be expanded digit by digit, so magnitudes are compared first.
            if (seconds.precision() - (long) seconds.scale() > MAX_FAST_DIGITS + 1
                    || seconds.abs().compareTo(MAX_SECONDS) >= 0) {
                throw malformed(0, line, "malformed, time must be smaller than " + MAX_SECONDS.toPlainString()
                        + " s but was " + Printable.shortened(text));
            }
            if (seconds.precision() - (long) seconds.scale() < -FRACTION_DIGITS - 1) {
                return 0;
            }
            return seconds.movePointRight(FRACTION_DIGITS).setScale(0, RoundingMode.HALF_UP).longValue();
        } catch (NumberFormatException e) {
            throw malformed(0, line, "malformed, time must be a number of seconds: " + shown(start, end));
        }
    }

    private int integer(int field, String name, int start, int end) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int p = fieldAt[field];
        int fieldEndAt = fieldEnd[field];
        boolean negative = buffer[p] == '-';
        if (negative) {
            p++;
        }
        int value = 0;
        // Six digits at most, so that no value overflows; no sensor has so many columns.
        boolean valid = p < fieldEndAt && fieldEndAt - p <= 6;
        for (; valid && p < fieldEndAt; p++) {
            valid = isDigit(buffer[p]);
            value = 10 * value + buffer[p] - '0';
        }
        if (!valid) {
            throw malformed(0, line, "malformed, " + name + " must be an integer: " + shown(start, end));
        }
        return negative ? -value : value;
    }

    private static boolean isDigit(byte character) {
        return character >= '0' && character <= '9';
    }

    private String text(int from, int to) {
        return new String(file.buffer, from, to - from, StandardCharsets.ISO_8859_1);
    }

    /** A line in a message: one that is long, or not text at all, must not fill the screen. */
    private String shown(int start, int end) {
        String all = text(start, Math.min(end, start + SHOWN_CHARACTERS)).strip();
        return "\"" + Printable.of(all) + (end - start > SHOWN_CHARACTERS ? "..." : "") + "\"";
    }

    /** Text has lines instead of bytes. */
    @Override
    String at(long event, long lineNumber) {
        return "[" + file.name + "] line " + lineNumber + ": ";
    }
}
