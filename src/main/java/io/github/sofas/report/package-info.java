/**
 * One page about one run: HTML that needs no other file, no network and no script. Open
 * {@link io.github.sofas.report.ReportCollector} first: it sees the labelled events and writes the page at the end.
 *
 * <p>Memory: time is cut into at most 512 bins, which double when they do not suffice; each segment keeps the bins in
 * which it lived.
 */
package io.github.sofas.report;
