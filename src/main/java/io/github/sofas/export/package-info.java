/**
 * Results as files. Open {@link io.github.sofas.export.FlowTable} first: it writes the row of every event, as Parquet,
 * NumPy's npz, or CSV by {@link io.github.sofas.export.FlowCsvWriter}. Beside it: {@link
 * io.github.sofas.export.TrackTable} for segments over time, {@link io.github.sofas.export.SegmentsCsv} for the track
 * planes, {@link io.github.sofas.export.RunSummary} for the figures of a run, {@link
 * io.github.sofas.export.ResultFiles} for files that are either whole or absent.
 *
 * <p>Sees events and flow; knows neither recordings nor the command line.
 */
package io.github.sofas.export;
