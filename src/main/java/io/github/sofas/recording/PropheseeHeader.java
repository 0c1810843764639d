package io.github.sofas.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The header lines of Prophesee's RAW and DAT files: {@code % key value}, with keys in upper or lower case. Newer
 * recorders end the header with {@code % end}. Without that, the header ends before the first line that does not start
 * with a per cent sign and a blank. Data may start with those bytes too, so an apparent line with a control character
 * is taken for data.
 *
 * <p>Source: openeb (prophesee-ai/openeb), {@code GenericHeader} and {@code PseeRawFileHeader}.
 */
final class PropheseeHeader {
    private static final int MOST_LINE_BYTES = 4096;
    private static final Pattern GEOMETRY = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
    private static final String END = "end";

    private final Map<String, String> values = new LinkedHashMap<>();

    private PropheseeHeader() {
    }

    /** Whether a header begins at the file's position. */
    static boolean startsAt(RecordingFile file) throws IOException {
        return file.require(2) && file.buffer[file.position] == '%' && file.buffer[file.position + 1] == ' ';
    }

    /**
     * Reads the header and leaves the file at the first byte of data.
     *
     * @throws MalformedRecordingException where the file ends inside a line
     */
    static PropheseeHeader read(RecordingFile file) throws IOException, MalformedRecordingException {
        PropheseeHeader header = new PropheseeHeader();
        while (startsAt(file)) {
            String line = line(file);
            if (line == null) {
                break;
            }
            String text = line.substring(1).strip();
            int blank = text.indexOf(' ');
            String key = (blank < 0 ? text : text.substring(0, blank)).toLowerCase(Locale.ROOT);
            if (key.equals(END)) {
                break;
            }
            header.values.putIfAbsent(key, blank < 0 ? "" : text.substring(blank + 1).strip());
        }
        return header;
    }

    /** Reads the line at the file's position and moves past it; returns null, without moving, where there is none. */
    private static String line(RecordingFile file) throws IOException, MalformedRecordingException {
        boolean more = file.require(MOST_LINE_BYTES);
        int start = file.position;
        int limit = Math.min(file.limit, start + MOST_LINE_BYTES);
        int end = start;
        while (end < limit && (file.buffer[end] & 0xFF) >= ' ' || end < limit && isBlank(file.buffer[end])) {
            end++;
        }
        if (end < limit && file.buffer[end] == '\n') {
            file.position = end + 1;
            return new String(file.buffer, start, end - start, StandardCharsets.ISO_8859_1);
        }
        if (end == limit && !more) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte " + file.offset()
                    + ": truncated, a line must end with a line feed but the file ends");
        }
        return null;
    }

    private static boolean isBlank(byte character) {
        return character == '\t' || character == '\r';
    }

    /** The value of a key; null where the key is missing. */
    String value(String key) {
        return values.get(key);
    }

    /** Whether at least one of the keys is there. */
    boolean hasOneOf(String... keys) {
        for (String key : keys) {
            if (values.containsKey(key)) {
                return true;
            }
        }
        return false;
    }

    /** Name of the events' encoding, such as EVT3, in capitals; null where the header does not say. */
    String encoding() {
        String format = value("format");
        if (format != null) {
            return format.split(";", 2)[0].strip().toUpperCase(Locale.ROOT).replace(".", "");
        }
        String evt = value("evt");
        return evt == null ? null : "EVT" + evt.replaceFirst("\\.0$", "").replace(".", "");
    }

    /** The value of an option of the format line, such as {@code endianness}; null where the option is missing. */
    private String option(String name) {
        String format = value("format");
        for (String option : format == null ? new String[0] : format.split(";")) {
            String[] parts = option.split("=", 2);
            if (parts.length == 2 && parts[0].strip().equalsIgnoreCase(name)) {
                return parts[1].strip();
            }
        }
        return null;
    }

    /** Whether the two halves of 64-bit words are swapped, as early EVT 2.1 recorders wrote them. */
    boolean isLegacyEvt21() {
        String order = option("endianness");
        return "legacy".equals(order == null ? value("endianness") : order);
    }

    /** Columns as the header writes them; null where it does not. */
    String width() {
        return side(1, "width");
    }

    /** Rows as the header writes them; null where it does not. */
    String height() {
        return side(2, "height");
    }

    private String side(int group, String name) {
        String geometry = value("geometry");
        if (geometry != null) {
            Matcher sides = GEOMETRY.matcher(geometry);
            return sides.matches() ? sides.group(group) : Printable.shortened(geometry);
        }
        return Printable.shortened(option(name) != null ? option(name) : value(name));
    }
}
