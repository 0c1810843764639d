package io.github.sofas.experiments;

import java.util.List;

/**
 * What came of one recording of a real camera.
 *
 * @param file its file name
 * @param about what is seen, and what is known to be true
 * @param header titles of the columns
 * @param rows per row a method
 * @param checks goals of the default preset
 * @param plots curves
 */
record RealExperiment(String file, String about, List<String> header, List<List<String>> rows,
                      List<Goal.Check> checks, List<Plot> plots) {
}
