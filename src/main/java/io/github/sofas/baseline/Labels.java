package io.github.sofas.baseline;

import io.github.sofas.flow.FlowOutput;

/** Writes the results of the methods of this package, which find flow but no segments. */
final class Labels {
    /** The segment of every event with flow. */
    static final int WITH_FLOW = 1;

    private Labels() {
    }

    static void checkCapacity(int size, FlowOutput output) {
        if (size > output.capacity()) {
            throw new IllegalArgumentException("output must hold the batch's " + size + " events but holds "
                    + output.capacity());
        }
    }

    /** Sets the label of event i; a velocity of exactly 0 means no flow. */
    static void set(FlowOutput output, int i, double vx, double vy) {
        output.vxPxPerS[i] = (float) vx;
        output.vyPxPerS[i] = (float) vy;
        output.segment[i] = vx == 0 && vy == 0 ? 0 : WITH_FLOW;
    }
}
