package io.github.sofas.recording;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The columns of a text recording: which field of a line holds what.
 *
 * @param names names of all columns, in the order of the fields
 * @param time index of the field with the time
 * @param x index of the field with the column
 * @param y index of the field with the row
 * @param polarity index of the field with the polarity
 * @param unit unit in the name of the time column; null where it has none
 */
public record TextColumns(List<String> names, int time, int x, int y, int polarity, TextTimeUnit unit) {
    /** Columns where neither header nor user names any: those of the Robotics and Perception Group's data sets. */
    static final TextColumns USUAL = new TextColumns(List.of("t", "x", "y", "polarity"), 0, 1, 2, 3, null);

    private static final Pattern TIME = Pattern.compile("(?:t|ts|time|times|timestamp|timestamps)[ _]?[\\[(]?"
            + "(|s|sec|seconds?|ms|milliseconds?|us|\u00b5s|\u03bcs|microseconds?|ns|nanoseconds?)[\\])]?");
    private static final List<String> X = List.of("x", "col", "column", "xs", "x_px");
    private static final List<String> Y = List.of("y", "row", "ys", "y_px");
    private static final List<String> POLARITY = List.of("p", "pol", "polarity", "polarities", "ps", "on", "sign");

    /** How many fields a line has. */
    int count() {
        return names.size();
    }

    /**
     * Finds the columns by their names.
     *
     * @param names names as a header or the user writes them; names other than those of time, x, y and polarity are
     *     ignored
     * @return the columns; nothing where one of the four is missing or comes twice
     */
    static Optional<TextColumns> named(List<String> names) {
        int[] at = new int[4];
        Arrays.fill(at, -1);
        TextTimeUnit unit = null;
        for (int i = 0; i < names.size(); i++) {
            String name = names.get(i).strip().toLowerCase(Locale.ROOT).replaceAll("^[\"']|[\"']$", "");
            Matcher time = TIME.matcher(name);
            int kind = time.matches() ? 0 : X.contains(name) ? 1 : Y.contains(name) ? 2
                    : POLARITY.contains(name) ? 3 : -1;
            if (kind >= 0) {
                if (at[kind] >= 0) {
                    return Optional.empty();
                }
                at[kind] = i;
                unit = kind == 0 ? TextTimeUnit.named(time.group(1)).orElse(null) : unit;
            }
        }
        return Arrays.stream(at).anyMatch(i -> i < 0) ? Optional.empty()
                : Optional.of(new TextColumns(List.copyOf(names), at[0], at[1], at[2], at[3], unit));
    }

    /** The column order of a file with its time in the given field, as the user would write it. */
    static String withTimeAt(int field) {
        List<String> names = new ArrayList<>(List.of("x", "y", "p"));
        names.add(field, "t");
        return String.join(",", names);
    }
}
