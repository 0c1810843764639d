package io.github.sofas.cli;

import io.github.sofas.export.RunSummary;
import io.github.sofas.recording.Printable;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarConsumer;
import me.tongfei.progressbar.ProgressBarStyle;

/**
 * Shows the progress of a command on standard error: a bar if that is a terminal, and a line per finished recording.
 * Used by several threads.
 */
final class RunProgress implements AutoCloseable {
    private static final int UPDATE_MS = 200;

    private final PrintWriter err;
    private final boolean quiet;
    private final ProgressBar bar;
    private final long startNs = System.nanoTime();
    private long events;
    private long eventsWithFlow;

    /**
     * Creates a display of progress.
     *
     * @param bar the bar; null for none
     */
    RunProgress(PrintWriter err, boolean quiet, ProgressBar bar) {
        this.err = err;
        this.quiet = quiet;
        this.bar = bar;
    }

    /**
     * Starts showing the progress through recordings.
     *
     * @param bytes total size of the recordings
     */
    static RunProgress start(PrintWriter err, boolean quiet, long bytes) {
        boolean shown = !quiet && standardErrorIsTerminal();
        return new RunProgress(err, quiet, shown ? bar(new Line(System.err), bytes) : null);
    }

    /** Creates a bar in megabytes; progress in events or recordings would be known only at the end. */
    static ProgressBar bar(ProgressBarConsumer line, long bytes) {
        return new ProgressBarBuilder().setInitialMax(Math.max(1, bytes)).setUnit(" MB", 1_000_000)
            .setStyle(ProgressBarStyle.ASCII).setUpdateIntervalMillis(UPDATE_MS).setConsumer(line)
            .hideEta().clearDisplayOnFinish().build();
    }

    /**
     * Starts showing the progress of work that is not measured in bytes.
     *
     * @param unit unit of the work, such as " s"
     * @param most total amount of work
     */
    static RunProgress start(PrintWriter err, boolean quiet, String unit, long most) {
        boolean shown = !quiet && standardErrorIsTerminal();
        return new RunProgress(err, quiet, !shown ? null : new ProgressBarBuilder().setInitialMax(Math.max(1, most))
            .setUnit(unit, 1).setStyle(ProgressBarStyle.ASCII).setUpdateIntervalMillis(UPDATE_MS)
            .setConsumer(new Line(System.err)).hideEta().clearDisplayOnFinish().build());
    }

    /** Shows how far the work has come. */
    synchronized void reached(long place) {
        if (bar != null) {
            bar.stepTo(place);
        }
    }

    /** The terminal's line on which the bar is drawn. Unlike the library's own, it leaves no empty line behind. */
    static final class Line extends ConsoleProgressBarConsumer {
        private final PrintStream stream;

        Line(PrintStream stream) {
            super(stream);
            this.stream = stream;
        }

        Line(PrintStream stream, int columns) {
            super(stream, columns);
            this.stream = stream;
        }

        @Override
        public void close() {
            stream.flush();
        }
    }

    /**
     * Whether standard error is a terminal. Java shows this only for standard input and output; Linux does so for
     * standard error, too.
     */
    static boolean standardErrorIsTerminal() {
        Path standardError = Path.of("/proc/self/fd/2");
        try {
            String target = Files.readSymbolicLink(standardError).toString();
            return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return System.console() != null;
        }
    }

    /** Counts bytes read and events labelled. */
    synchronized void add(long newBytes, long newEvents, long newEventsWithFlow) {
        events += newEvents;
        eventsWithFlow += newEventsWithFlow;
        if (bar != null) {
            double seconds = (System.nanoTime() - startNs) / 1e9;
            bar.stepBy(newBytes);
            bar.setExtraMessage(speed(events, eventsWithFlow, events / seconds));
        }
    }

    /** Shows the line of a finished recording. */
    synchronized void finished(String name, RunSummary summary) {
        if (!quiet) {
            long segments = summary.countLarge();
            long all = summary.recording().events();
            String reason = summary.withoutFlow().isEmpty() ? "" : "; most found no flow: " + summary.withoutFlow();
            say(String.format(Locale.ROOT, "%s: %d events, %s, %d %s, %.2f s%s", name, all,
                speed(all, summary.eventsWithFlow(), summary.eventsPerSecond()), segments,
                segments == 1 ? "segment" : "segments", summary.seconds().wall(), reason));
        }
    }

    static String speed(long events, long eventsWithFlow, double eventsPerSecond) {
        double share = events == 0 ? 0 : 100.0 * eventsWithFlow / events;
        return String.format(Locale.ROOT, "%.1f %% with flow, %.0f events/s", share, eventsPerSecond);
    }

    /** Shows a line, above the bar if there is one. */
    synchronized void say(String line) {
        clear();
        err.println(Printable.of(line));
    }

    /** Clears the bar's line until the bar is drawn again. */
    synchronized void clear() {
        if (bar != null) {
            err.print("\r\u001b[K");
            err.flush();
        }
    }

    @Override
    public synchronized void close() {
        if (bar != null) {
            bar.close();
            clear();
        }
    }
}
