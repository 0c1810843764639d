package io.github.sofas.experiments;

import java.util.List;

/**
 * Lines over one axis, as numbers: drawn in the report and written to CSV.
 *
 * @param id its name in CSV
 * @param title its name for people
 * @param xTitle what the horizontal axis is, with its unit
 * @param yTitle what the vertical axis is, with its unit
 * @param lines what is drawn, the last on top
 */
record Plot(String id, String title, String xTitle, String yTitle, List<Line> lines) {

    /** What a line stands for, which decides its colour. */
    enum Ink {
        /** What is true. */
        TRUTH,
        /** A method, by its own name. */
        SOFAS_DEFAULT, SOFAS_PAPER, LUCAS_KANADE, LOCAL_PLANES,
        /** One of several of a kind: coloured by its place among the plot's lines. */
        BY_PLACE;

        static Ink of(ComparedMethod method) {
            return valueOf(method.name());
        }
    }

    /**
     * One line.
     *
     * @param name its name in the legend
     * @param ink its colour
     * @param x positions, rising
     * @param y values; not a number where there is none, which leaves a gap
     */
    record Line(String name, Ink ink, double[] x, double[] y) {
        Line(String name, Ink ink, Curve curve) {
            this(name, ink, curve.timeS(), curve.values());
        }
    }
}
