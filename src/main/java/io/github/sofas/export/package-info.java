/**
 * Results as files. Open {@link io.github.sofas.export.FlowTable} first: it writes one row for every event, as Parquet,
 * NumPy's npz, or CSV by {@link io.github.sofas.export.FlowCsvWriter}. The other results are
 * {@link io.github.sofas.export.TrackTable} for segments over time, {@link io.github.sofas.export.SegmentsCsv} for the
 * track planes, and {@link io.github.sofas.export.RunSummary} for the figures of a run.
 * {@link io.github.sofas.export.ResultFiles} makes files that are either complete or absent.
 *
 * <p>This package uses events and flow, and depends on neither recordings nor the command line.
 */
package io.github.sofas.export;
