package io.github.sofas.recording;

import java.util.Locale;
import java.util.Optional;

/** Unit of the times of a text recording. */
public enum TextTimeUnit {
    /** Seconds. */
    S(6),
    /** Milliseconds. */
    MS(3),
    /** Microseconds. */
    US(0),
    /** Nanoseconds; rounded to microseconds. */
    NS(-3);

    /** Number of digits by which a number of this unit is shifted to the left to become µs. */
    final int digits;

    TextTimeUnit(int digits) {
        this.digits = digits;
    }

    /**
     * {@return the unit of a symbol: s, ms, us (µs) or ns, or the word for it}
     *
     * @param symbol in upper or lower case
     */
    public static Optional<TextTimeUnit> named(String symbol) {
        switch (symbol.strip().toLowerCase(Locale.ROOT)) {
            case "s":
            case "sec":
            case "second":
            case "seconds":
                return Optional.of(S);
            case "ms":
            case "millisecond":
            case "milliseconds":
                return Optional.of(MS);
            case "us":
            case "\u00b5s":
            case "\u03bcs":
            case "microsecond":
            case "microseconds":
                return Optional.of(US);
            case "ns":
            case "nanosecond":
            case "nanoseconds":
                return Optional.of(NS);
            default:
                return Optional.empty();
        }
    }

    /** Returns the unit's symbol in ASCII letters. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Converts a number of this unit to seconds. */
    double seconds(double number) {
        return number * Math.pow(10, digits - 6);
    }
}
