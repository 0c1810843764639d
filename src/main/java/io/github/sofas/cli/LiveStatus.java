package io.github.sofas.cli;

import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.Segment;
import io.github.sofas.live.LiveSource;
import java.io.PrintWriter;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.HdrHistogram.Histogram;

/**
 * How a live stream goes: one line a second, and one at the end. Told by the thread that labels, asked by the one that
 * shows.
 */
final class LiveStatus {
    /** Segments that fit on a line. */
    private static final int SEGMENTS_SHOWN = 4;
    private static final long LONGEST_US = 60_000_000;
    private static final int DIGITS = 3;

    private final LiveSource source;
    private final PrintWriter err;
    private final Histogram latencyUs = new Histogram(LONGEST_US, DIGITS);
    private long startNs;
    private long shownNs;
    private long events;
    private long eventsWithFlow;
    /** Snapshot for the line that is due, by the thread that labels. */
    private boolean due;
    private List<Segment> segments = List.of();

    LiveStatus(LiveSource source, PrintWriter err) {
        this.source = source;
        this.err = err;
    }

    /** Notes that the source sends from now on. */
    synchronized void started() {
        startNs = System.nanoTime();
        shownNs = startNs;
    }

    /**
     * Notes a batch.
     *
     * @param latencyNs from its arrival to its last label
     * @param labeller asked for its segments when a line is due
     */
    synchronized void labelled(int newEvents, int newEventsWithFlow, long latencyNs, EventLabeller labeller) {
        events += newEvents;
        eventsWithFlow += newEventsWithFlow;
        latencyUs.recordValue(Math.min(LONGEST_US, latencyNs / 1000));
        if (due) {
            due = false;
            segments = labeller.segments();
        }
    }

    /** Shows what happened since the last line. */
    synchronized void show() {
        long now = System.nanoTime();
        err.println(line((now - startNs) / 1e9, (now - shownNs) / 1e9));
        err.flush();
        shownNs = now;
        events = 0;
        eventsWithFlow = 0;
        due = true;
    }

    private String line(double sinceStartS, double sinceShownS) {
        StringBuilder line = new StringBuilder(String.format(Locale.ROOT,
            "%5.0f s: %.0f events/s, %.1f %% with flow, queue %d of %d, %d events dropped", sinceStartS,
            events / sinceShownS, events == 0 ? 0 : 100.0 * eventsWithFlow / events, source.packetsWaiting(),
            source.queueLimit(), source.eventsDropped()));
        if (source.packetsLost() > 0) {
            line.append(", ").append(source.packetsLost()).append(" packets lost");
        }
        line.append(segments.size() == 1 ? ", 1 segment" : ", " + segments.size() + " segments");
        segments.stream().sorted(Comparator.comparingLong(Segment::events).reversed()).limit(SEGMENTS_SHOWN)
            .forEach(segment -> line.append(String.format(Locale.ROOT, "  #%d (%.0f, %.0f) px/s", segment.id(),
                segment.vxPxPerS(), segment.vyPxPerS())));
        if (segments.size() > SEGMENTS_SHOWN) {
            line.append(" ...");
        }
        return line.toString();
    }

    /** How long events took from their arrival to their label. */
    synchronized String latency() {
        return String.format(Locale.ROOT, "from arrival to label: p50 %.1f ms, p99 %.1f ms, longest %.1f ms",
            latencyUs.getValueAtPercentile(50) / 1e3, latencyUs.getValueAtPercentile(99) / 1e3,
            latencyUs.getMaxValue() / 1e3);
    }
}
