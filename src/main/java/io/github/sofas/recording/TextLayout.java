package io.github.sofas.recording;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/**
 * The layout of a text recording, given by the user or a header, or found from the first and last lines.
 *
 * @param columns which field holds what
 * @param separator a comma, semicolon or tab that separates fields, so that some may be empty; 0 where any blanks, tabs
 *     and commas separate them
 * @param unit unit of the times
 * @param bodyAt byte at which the first line after the header begins
 * @param headerLines number of lines before that byte
 * @param note message about an assumption that nothing states; null where there was none
 */
record TextLayout(TextColumns columns, char separator, TextTimeUnit unit, int bodyAt, int headerLines, String note) {
    private static final byte[] BOM = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    private static final Pattern ANY = Pattern.compile("[ \\t,\\r]+");
    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d{1,9})?");
    private static final int MOST_SAMPLED = 250;
    private static final int TAIL_BYTES = 4096;

    /** Fewer whole numbers than this do not determine their unit. */
    private static final int FEWEST_WHOLE = 10;
    /** Number of events from which on the rate is meaningful. */
    private static final int FEWEST_FOR_RATE = 100;
    /** No recording is longer than this, in s: 12 days. */
    private static final double LONGEST_S = 1e6;
    /** Mean rates of recordings, in events/s: from a few moving pixels to the limit of the largest sensors. */
    private static final double SLOWEST = 100;
    private static final double FASTEST_WHOLE = 2e7;
    private static final double FASTEST = 2e8;
    /** Times of a clock that counts from 1970, in ns: no camera's own clock reaches them. */
    private static final double EPOCH_NS = 9e17;
    /** Largest time, in any unit; larger numbers are damage. */
    private static final double MOST = 1e20;
    private static final int FEW = 5;
    private static final int FEWEST_FOR_ORDER = 10;
    private static final double MOST_FALLS = 0.1;

    /**
     * Finds the layout from the start and the end of a file. The position in the file does not change.
     *
     * @throws MalformedRecordingException where the user must give columns or unit
     */
    static TextLayout of(RecordingFile file, RecordingOptions options)
            throws IOException, MalformedRecordingException {
        boolean more = file.require(RecordingFile.BUFFER_BYTES);
        int p = file.position;
        if (Arrays.equals(file.buffer, p, Math.min(file.limit, p + BOM.length), BOM, 0, BOM.length)) {
            p += BOM.length;
        }
        Header header = Header.of(file, p, options.columns());
        TextColumns columns = header.columns;
        boolean isGiven = columns != null;
        TextColumns known = isGiven ? columns : TextColumns.USUAL;
        Sample sample = Sample.of(file, header.bodyAt, header.separator, known, more);
        if (!isGiven) {
            sample.checkOrder(file);
        }
        TextTimeUnit given = options.timeUnit() != null ? options.timeUnit() : known.unit();
        TextTimeUnit unit = given != null ? given : sample.unit(file);
        String note = given != null || !sample.isWhole || sample.times.isEmpty() ? null : "[" + file.name
                + "] times are whole numbers without a unit; taken as " + unit + ": " + sample.rate(unit)
                + "; --time s, ms, us or ns sets another";
        return new TextLayout(known, header.separator, unit, header.bodyAt - file.position, header.lines, note);
    }

    /** Whether the start of a file reads as events, which distinguishes recordings from other texts in a folder. */
    static boolean fits(RecordingFile file) throws IOException {
        try {
            TextLayout layout = of(file, RecordingOptions.defaults().withTimeUnit(TextTimeUnit.US));
            Sample sample = Sample.of(file, file.position + layout.bodyAt, layout.separator, layout.columns, true);
            return sample.times.size() > 0 && sample.strange == 0;
        } catch (MalformedRecordingException e) {
            return false;
        }
    }

    private static int lineEnd(RecordingFile file, int from) {
        int end = from;
        while (end < file.limit && file.buffer[end] != '\n') {
            end++;
        }
        return end;
    }

    private static String text(RecordingFile file, int from, int end) {
        return new String(file.buffer, from, end - from, StandardCharsets.UTF_8).strip();
    }

    private static char separatorOf(String line) {
        return line.indexOf(',') >= 0 ? ',' : line.indexOf(';') >= 0 ? ';' : line.indexOf('\t') >= 0 ? '\t' : 0;
    }

    private static List<String> fields(String line, char separator) {
        if (separator == 0) {
            return List.of(ANY.split(line));
        }
        return Arrays.stream(line.split(Pattern.quote(String.valueOf(separator)), -1)).map(String::strip).toList();
    }

    /** Whether a line has words where events have numbers. */
    private static boolean hasWordsOnly(String line, char separator) {
        return fields(line, separator).stream().noneMatch(field -> NUMBER.matcher(field).matches())
                && line.chars().anyMatch(Character::isLetter);
    }

    private static MalformedRecordingException wrong(RecordingFile file, long line, String rule) {
        return new MalformedRecordingException("[" + file.name + "] line " + line + ": " + rule);
    }

    /** The part before the first event: comments, one of which may name the columns, and a line with their names. */
    private static final class Header {
        private final boolean isGiven;
        private TextColumns columns;
        private char separator;
        private int bodyAt;
        private int lines;

        private Header(TextColumns given) {
            isGiven = given != null;
            columns = given;
        }

        static Header of(RecordingFile file, int from, TextColumns given) throws MalformedRecordingException {
            Header header = new Header(given);
            header.bodyAt = from;
            int at = from;
            int line = 0;
            boolean isBody = false;
            while (!isBody && at < file.limit) {
                int end = lineEnd(file, at);
                String text = text(file, at, end);
                at = Math.min(end + 1, file.limit);
                line++;
                isBody = header.isLast(text, line, at, file);
            }
            return header;
        }

        /** Takes a line and returns whether no line of the header follows. */
        private boolean isLast(String text, int line, int next, RecordingFile file)
                throws MalformedRecordingException {
            boolean isComment = text.startsWith("#");
            String names = isComment ? text.substring(1).strip() : text;
            if (names.isEmpty()) {
                return false;
            }
            char split = separatorOf(names);
            TextColumns found = TextColumns.named(fields(names, split)).orElse(null);
            boolean isHeader = found != null || !isComment && hasWordsOnly(text, split);
            if (isHeader) {
                if (found == null && columns == null) {
                    throw wrong(file, line, "unsupported, a header must name t, x, y and p, or --columns say which "
                            + "field is which, but was \"" + Printable.shortened(text) + "\"");
                }
                columns = columns == null ? found : columns;
                separator = split;
                bodyAt = next;
                lines = line;
            } else if (!isComment && separator == 0 && (isGiven || split == ';')) {
                separator = split;
            }
            return !isComment;
        }
    }

    /** The first lines, as a sample of the whole recording. */
    private static final class Sample {
        private final List<BigDecimal> times = new ArrayList<>();
        /** How often each of the first four fields fell from one line to the next. */
        private final int[] falls = new int[4];
        private final double[] before = new double[4];
        private int strange;
        private boolean isWhole = true;
        private double events;
        private List<BigDecimal> last = times;

        static Sample of(RecordingFile file, int from, char separator, TextColumns columns, boolean more)
                throws IOException {
            Sample sample = new Sample();
            int p = from;
            while (p < file.limit && sample.times.size() < MOST_SAMPLED) {
                int end = lineEnd(file, p);
                if (end == file.limit && more) {
                    break;
                }
                sample.add(text(file, p, end), separator, columns);
                p = end + 1;
            }
            sample.events = sample.times.size();
            long rest = file.size() - file.offset() - (p - file.position);
            if (rest > 0 && p > from && file.isSeekable()) {
                sample.events *= 1 + (double) rest / (p - from);
                sample.addLast(file, separator, columns);
            }
            return sample;
        }

        private void add(String line, char separator, TextColumns columns) {
            if (line.isEmpty() || line.startsWith("#")) {
                return;
            }
            List<String> fields = fields(line, separator);
            if (fields.size() < columns.count() || !NUMBER.matcher(fields.get(columns.time())).matches()) {
                strange++;
                return;
            }
            for (int i = 0; i < falls.length; i++) {
                if (NUMBER.matcher(fields.get(i)).matches()) {
                    double value = Double.parseDouble(fields.get(i));
                    falls[i] += times.isEmpty() || value >= before[i] ? 0 : 1;
                    before[i] = value;
                }
            }
            addTime(fields.get(columns.time()));
        }

        private void addTime(String field) {
            if (Math.abs(Double.parseDouble(field)) > MOST) {
                return;
            }
            BigDecimal exact = new BigDecimal(field);
            isWhole &= exact.signum() == 0 || exact.stripTrailingZeros().scale() <= 0;
            times.add(exact);
        }

        /** Takes the last lines, so that the span of time is that of the whole recording. */
        private void addLast(RecordingFile file, char separator, TextColumns columns) throws IOException {
            String[] lines = file.tail(TAIL_BYTES).split("\n");
            Sample tail = new Sample();
            for (int i = 1; i < lines.length; i++) {
                tail.add(lines[i].strip(), separator, columns);
            }
            last = tail.times.isEmpty() ? times : tail.times;
        }

        /**
         * The span of time from the first lines to the last. Each end is the middle time of a few lines, so that a
         * damaged time does not count.
         */
        private double span() {
            int few = Math.min(FEW, last.size());
            return middle(last.subList(last.size() - few, last.size()))
                    .subtract(middle(times.subList(0, Math.min(FEW, times.size())))).abs().doubleValue();
        }

        private static BigDecimal middle(List<BigDecimal> some) {
            return some.stream().sorted().skip(some.size() / 2).findFirst().orElse(BigDecimal.ZERO);
        }

        /**
         * Checks that the first field can be the time, which does not fall, where neither header nor user names
         * columns.
         */
        void checkOrder(RecordingFile file) throws MalformedRecordingException {
            int most = (int) (MOST_FALLS * times.size());
            if (times.size() < FEWEST_FOR_ORDER || falls[0] <= most) {
                return;
            }
            for (int i = 1; i < falls.length; i++) {
                if (falls[i] == 0) {
                    throw wrong(file, 1, "malformed, the first field must be the time but falls " + falls[0]
                            + " times in " + times.size() + " lines, while field " + (i + 1) + " never does; --columns "
                            + TextColumns.withTimeAt(i) + " says so, if that is the order");
                }
            }
        }

        /**
         * Determines the unit that the numbers indicate.
         *
         * @throws MalformedRecordingException where they fit no unit well enough
         */
        TextTimeUnit unit(RecordingFile file) throws MalformedRecordingException {
            if (times.isEmpty()) {
                return TextTimeUnit.S;
            }
            TextTimeUnit unit = TextTimeUnit.S;
            double fastest = FASTEST;
            if (isWhole) {
                unit = times.get(0).doubleValue() >= EPOCH_NS || areThousands() ? TextTimeUnit.NS : TextTimeUnit.US;
                fastest = FASTEST_WHOLE;
                if (times.size() < FEWEST_WHOLE) {
                    throw unknownUnit(file, "but " + times.size() + " whole numbers do not show it");
                }
            }
            double span = unit.seconds(span());
            boolean isLong = times.size() >= FEWEST_WHOLE && span > LONGEST_S;
            boolean isSlow = events >= FEWEST_FOR_RATE && events < SLOWEST * span;
            boolean isFast = events >= FEWEST_FOR_RATE && events > fastest * span;
            if (isLong || isSlow || isFast) {
                throw unknownUnit(file, "but as " + unit + " the recording would have " + rate(unit));
            }
            return unit;
        }

        private MalformedRecordingException unknownUnit(RecordingFile file, String why) {
            return wrong(file, 1, "malformed, the time unit must be given, " + why
                    + "; use --time s, ms, us or ns");
        }

        /** Whether all times differ by thousands, as times do that were µs and are written as ns. */
        private boolean areThousands() {
            BigDecimal thousand = BigDecimal.valueOf(1000);
            boolean differ = false;
            for (BigDecimal time : times) {
                BigDecimal apart = time.subtract(times.get(0));
                if (apart.remainder(thousand).signum() != 0) {
                    return false;
                }
                differ |= apart.signum() != 0;
            }
            return differ;
        }

        /** The number of events, the duration and the mean rate that the recording would have in this unit. */
        String rate(TextTimeUnit unit) {
            double span = unit.seconds(span());
            String about = "about " + rounded(events, 2) + " events in " + rounded(span, 3) + " s";
            return span > 0 ? about + ", " + rounded(events / span, 2) + " per second" : about;
        }

        private static String rounded(double number, int digits) {
            return new BigDecimal(number).round(new MathContext(digits)).stripTrailingZeros().toPlainString();
        }
    }
}
