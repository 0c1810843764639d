package io.github.sofas.experiments;

import java.util.List;

/**
 * A plot as numbers: lines over one axis, which are drawn in the report and written to CSV.
 *
 * @param id name of the plot in CSV
 * @param title name of the plot for people
 * @param xTitle quantity of the horizontal axis, with its unit
 * @param yTitle quantity of the vertical axis, with its unit
 * @param lines the lines, the last on top
 */
record Plot(String id, String title, String xTitle, String yTitle, List<Line> lines) {

    /** The meaning of a line, which determines its colour. */
    enum Ink {
        /** The true values. */
        TRUTH,
        /** A method, by its own name. */
        SOFAS_DEFAULT, SOFAS_PAPER, LUCAS_KANADE, LOCAL_PLANES,
        /** One of several lines of a kind, coloured by its place among the plot's lines. */
        BY_PLACE;

        static Ink of(ComparedMethod method) {
            return valueOf(method.name());
        }
    }

    /**
     * One line.
     *
     * @param name name of the line in the legend
     * @param ink meaning of the line, which determines its colour
     * @param x positions, increasing
     * @param y values; NaN where there is no value, which leaves a gap
     */
    record Line(String name, Ink ink, double[] x, double[] y) {
        Line(String name, Ink ink, Curve curve) {
            this(name, ink, curve.timeS(), curve.values());
        }
    }
}
