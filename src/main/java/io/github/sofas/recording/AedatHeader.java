package io.github.sofas.recording;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The header lines of AEDAT 1.0, 2.0 and 3.x.
 *
 * <p>AEDAT 3.x and recorders since 2018 end the header with an end line; older files do not. An older header ends
 * before the first line that does not start with {@code #}. Data may start with that byte too, so an apparent line with
 * a control character is taken for data. It still counts as a line of the header where an end line comes later, or
 * where nearly all else in it is text.
 *
 * @param chip chip named by the AEChip line (1.0, 2.0) or the first Source line (3.x), or null
 * @param source the number of the first Source line, or null
 * @param encoding encoding named by the Format line of 3.x, or null
 * @param hasEndLine whether the end line was met
 */
record AedatHeader(String chip, Integer source, String encoding, boolean hasEndLine) {
    private static final Pattern CHIP = Pattern.compile("#\\s*AEChip:\\s*(\\S+).*", Pattern.CASE_INSENSITIVE);
    private static final Pattern SOURCE = Pattern.compile("#Source (\\d{1,5}):\\s*(\\S+).*", Pattern.CASE_INSENSITIVE);
    private static final Pattern ENCODING = Pattern.compile("#Format:\\s*(\\S+).*", Pattern.CASE_INSENSITIVE);
    private static final Pattern END = Pattern.compile("#(\\s*End Of ASCII Header|!END-HEADER)",
            Pattern.CASE_INSENSITIVE);
    /** Bytes that are kept from the start of a line; the lines that mean something are shorter. */
    private static final int KEPT_BYTES = 512;

    /** Lines in which the end line is searched. A header has few lines; records hold line feeds by chance. */
    private static final int MOST_LINES_AHEAD = 2000;
    /** Lines shorter than this may be records that look like text by chance. */
    private static final int FEWEST_TEXT = 16;
    private static final double MOSTLY = 0.8;

    /** Reads the header and leaves the file at the first record. */
    static AedatHeader read(RecordingFile file) throws IOException, MalformedRecordingException {
        String chip = null;
        Integer source = null;
        String encoding = null;
        boolean hasEndLine = false;
        byte[] line = new byte[KEPT_BYTES];
        while (file.require(1) && file.buffer[file.position] == '#') {
            long lineOffset = file.offset();
            int length = 0;
            int next = 0;
            while (file.require(1) && (next = file.buffer[file.position] & 0xFF) != '\n' && !isControl(next)) {
                if (length < KEPT_BYTES) {
                    line[length++] = (byte) next;
                }
                file.position++;
            }
            if (file.available() == 0) {
                throw new MalformedRecordingException("[" + file.name + "] header at byte " + lineOffset
                        + ": truncated, a line must end with a line feed but the file ends");
            }
            if (next != '\n' && !isText(file, lineOffset)) {
                file.seek(lineOffset);
                break;
            }
            while (next != '\n' && file.require(1)) {
                next = file.buffer[file.position] & 0xFF;
                if (next != '\n' && length < KEPT_BYTES) {
                    line[length++] = (byte) next;
                }
                file.position += next != '\n' ? 1 : 0;
            }
            file.position++;
            String text = new String(line, 0, length, StandardCharsets.ISO_8859_1).strip();
            if (END.matcher(text).matches()) {
                hasEndLine = true;
                break;
            }
            Matcher chipLine = CHIP.matcher(text);
            Matcher sourceLine = SOURCE.matcher(text);
            Matcher encodingLine = ENCODING.matcher(text);
            if (chip == null && chipLine.matches()) {
                chip = Printable.shortened(chipLine.group(1));
            } else if (chip == null && sourceLine.matches()) {
                source = Integer.valueOf(sourceLine.group(1));
                chip = Printable.shortened(sourceLine.group(2));
            } else if (encoding == null && encodingLine.matches()) {
                encoding = Printable.shortened(encodingLine.group(1));
            }
        }
        return new AedatHeader(chip, source, encoding, hasEndLine);
    }

    /**
     * Whether a line that holds a control character belongs to the header all the same: the end line comes later, or
     * nearly all of the line is text. Leaves the file where it was.
     */
    private static boolean isText(RecordingFile file, long lineOffset) throws IOException {
        long here = file.offset();
        file.seek(lineOffset);
        file.require(RecordingFile.BUFFER_BYTES);
        String ahead = new String(file.buffer, file.position, file.available(), StandardCharsets.ISO_8859_1);
        file.seek(here);
        file.require(1);
        int end = ahead.indexOf('\n');
        if (end < 0) {
            return false;
        }
        if (ahead.substring(end).lines().limit(MOST_LINES_AHEAD)
                .anyMatch(line -> END.matcher(line.strip()).matches())) {
            return true;
        }
        long printable = ahead.substring(0, end).chars().filter(c -> c >= ' ' && c <= '~').count();
        return end >= FEWEST_TEXT && printable >= MOSTLY * end;
    }

    private static boolean isControl(int character) {
        return character < ' ' && character != '\t' && character != '\r';
    }
}
