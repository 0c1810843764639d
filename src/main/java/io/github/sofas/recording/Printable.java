package io.github.sofas.recording;

/**
 * Makes text from a file, or a file's name, safe for a line on a terminal. Control characters could move the cursor or
 * worse, so each is replaced by a question mark.
 */
public final class Printable {
    private static final int LONGEST = 200;

    private Printable() {
    }

    /**
     * {@return the text without control characters}
     *
     * @param text from a file
     */
    public static String of(String text) {
        return text.replaceAll("\\p{Cc}", "?");
    }

    /** The text without control characters, cut where it is longer than a terminal's lines; null stays null. */
    static String shortened(String text) {
        if (text == null) {
            return null;
        }
        return of(text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text);
    }
}
