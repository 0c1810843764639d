package io.github.sofas.experiments;

import java.util.List;

/**
 * The results of one recording of a real camera: a table, goals and curves.
 *
 * @param file file name of the recording
 * @param about what the recording shows, and what is known about its true velocity
 * @param header titles of the columns
 * @param rows one row per method, or per sighting or known value
 * @param checks the goals of the default preset and what it reached
 * @param plots curves over time
 */
record RealExperiment(String file, String about, List<String> header, List<List<String>> rows,
                      List<Goal.Check> checks, List<Plot> plots) {
}
