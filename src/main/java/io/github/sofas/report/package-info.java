/**
 * One page about one run: HTML that needs no other file, no network and no script. Open
 * {@link io.github.sofas.report.ReportCollector} first: it sees the labelled events and writes the page at the end.
 *
 * <p>Memory does not grow with the recording. Time is divided into at most 512 bins, which double in length when they
 * do not suffice. Each segment keeps the bins in which it lived, at most 10 KB. Of the segments that ended, the 256
 * with the most events are kept. The events of the pictures are read again at the end, and the clip goes through a
 * temporary file.
 */
package io.github.sofas.report;
