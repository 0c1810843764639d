package io.github.sofas.cli;

import io.github.sofas.flow.Segment;
import io.github.sofas.live.LiveSource;
import io.github.sofas.recording.Printable;
import java.io.PrintWriter;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.HdrHistogram.Histogram;

/**
 * Status of a live stream: one line per second, and the latency for the line at the end. The labelling thread reports
 * batches, and another thread shows the lines.
 */
final class LiveStatus {
    /** Segments that fit on a line. */
    private static final int SEGMENTS_SHOWN = 4;
    private static final int INDENT = 8;
    private static final long LONGEST_US = 60_000_000;
    private static final int DIGITS = 3;

    private final LiveSource source;
    private final PrintWriter err;
    private final int columns;
    private final LongSupplier clockNs;
    private final Histogram latencyUs = new Histogram(LONGEST_US, DIGITS);
    private boolean started;
    private long startNs;
    private long shownNs;
    private long events;
    private long eventsWithFlow;
    /** Whether the labelling thread is to take a snapshot of the segments for the next line. */
    private boolean due;
    private List<Segment> segments = List.of();

    /**
     * Creates the status of a stream.
     *
     * @param columns width of the terminal that {@code err} writes to
     * @param clockNs supplies the time in ns
     */
    LiveStatus(LiveSource source, PrintWriter err, int columns, LongSupplier clockNs) {
        this.source = source;
        this.err = err;
        this.columns = columns;
        this.clockNs = clockNs;
    }

    /** Notes that the source sends from now on. */
    synchronized void started() {
        started = true;
        startNs = clockNs.getAsLong();
        shownNs = startNs;
    }

    /**
     * Notes a labelled batch.
     *
     * @param latencyNs time from the arrival of the batch to its last label
     * @param living supplies the segments; called only when a line is due
     */
    synchronized void labelled(int newEvents, int newEventsWithFlow, long latencyNs,
                               Supplier<List<Segment>> living) {
        events += newEvents;
        eventsWithFlow += newEventsWithFlow;
        latencyUs.recordValue(Math.min(LONGEST_US, latencyNs / 1000));
        if (due) {
            due = false;
            segments = living.get();
        }
    }

    /** Shows a warning at once. */
    void warn(String message) {
        err.println(Printable.of(message));
        err.flush();
    }

    /** Shows what happened since the last line. */
    void show() {
        String line = line();
        if (line != null) {
            // Not under the lock: labelling goes on even if the terminal is stopped.
            err.println(line);
            err.flush();
        }
    }

    private synchronized String line() {
        if (!started) {
            return null;
        }
        long now = clockNs.getAsLong();
        double seconds = (now - shownNs) / 1e9;
        StringBuilder line = new StringBuilder(String.format(Locale.ROOT,
            "%5.0f s: %7.0f events/s, %5.1f %% flow, queue %3d/%d, %d dropped, %d %s", (now - startNs) / 1e9,
            events / seconds, events == 0 ? 0 : 100.0 * eventsWithFlow / events, source.packetsWaiting(),
            source.queueLimit(), source.eventsDropped(), segments.size(),
            segments.size() == 1 ? "segment" : "segments"));
        if (source.packetsLost() > 0) {
            line.append(", ").append(source.packetsLost()).append(" packets lost");
        }
        appendSegments(line);
        shownNs = now;
        events = 0;
        eventsWithFlow = 0;
        due = true;
        return line.toString();
    }

    /** Appends the largest segments, on a line of their own if they do not fit. */
    private void appendSegments(StringBuilder line) {
        StringBuilder velocities = new StringBuilder();
        segments.stream().sorted(Comparator.comparingLong(Segment::events).reversed()).limit(SEGMENTS_SHOWN)
            .forEach(segment -> velocities.append(String.format(Locale.ROOT, " #%d (%d, %d)", segment.id(),
                Math.round(segment.vxPxPerS()), Math.round(segment.vyPxPerS()))));
        if (velocities.length() > 0) {
            velocities.append(segments.size() > SEGMENTS_SHOWN ? " ... px/s" : " px/s");
            boolean fits = line.length() + 1 + velocities.length() < columns;
            line.append(fits ? ":" : System.lineSeparator() + " ".repeat(INDENT)).append(velocities);
        }
    }

    /** The time that events took from their arrival to their label, as text. */
    synchronized String latency() {
        if (latencyUs.getTotalCount() == 0) {
            return "no event came in";
        }
        return String.format(Locale.ROOT, "from arrival to label: p50 %.1f ms, p99 %.1f ms, p99.9 %.1f ms, "
            + "longest %.1f ms", latencyUs.getValueAtPercentile(50) / 1e3, latencyUs.getValueAtPercentile(99) / 1e3,
            latencyUs.getValueAtPercentile(99.9) / 1e3, latencyUs.getMaxValue() / 1e3);
    }
}
