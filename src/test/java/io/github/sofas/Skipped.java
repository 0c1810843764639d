package io.github.sofas;

import org.junit.AssumptionViolatedException;

/** Skips a test and says why, in a form that the build prints beside its name. */
public final class Skipped {
    private Skipped() {
    }

    /** Skips the test that calls it; always throws. */
    public static AssumptionViolatedException because(String reason) {
        System.out.println("skipped: " + reason);
        throw new AssumptionViolatedException(reason);
    }
}
