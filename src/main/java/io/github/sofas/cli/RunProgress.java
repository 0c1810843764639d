package io.github.sofas.cli;

import io.github.sofas.export.RunSummary;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/**
 * What is shown while recordings run: a bar where standard error is a terminal, and a line for each that is finished.
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

    private RunProgress(PrintWriter err, boolean quiet, ProgressBar bar) {
        this.err = err;
        this.quiet = quiet;
        this.bar = bar;
    }

    /** Starts showing. */
    static RunProgress start(PrintWriter err, boolean quiet, int recordings) {
        ProgressBar bar = null;
        if (!quiet && standardErrorIsTerminal()) {
            bar = new ProgressBarBuilder().setTaskName("sofas").setInitialMax(recordings).setUnit(" recordings", 1)
                .setStyle(ProgressBarStyle.ASCII).setUpdateIntervalMillis(UPDATE_MS)
                .setConsumer(new ConsoleProgressBarConsumer(System.err)).clearDisplayOnFinish().build();
        }
        return new RunProgress(err, quiet, bar);
    }

    /** Java itself tells only of standard input and output; Linux tells of standard error. */
    private static boolean standardErrorIsTerminal() {
        Path standardError = Path.of("/proc/self/fd/2");
        try {
            String target = Files.readSymbolicLink(standardError).toString();
            return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return System.console() != null;
        }
    }

    /** Counts labelled events. */
    synchronized void add(int newEvents, int newEventsWithFlow) {
        events += newEvents;
        eventsWithFlow += newEventsWithFlow;
        if (bar != null) {
            double seconds = (System.nanoTime() - startNs) / 1e9;
            bar.setExtraMessage(figures(events, eventsWithFlow, events / seconds));
        }
    }

    /** Shows the line of a recording that is finished. */
    synchronized void finished(String name, RunSummary summary) {
        if (bar != null) {
            bar.step();
        }
        if (!quiet) {
            int segments = summary.segments().size();
            say(String.format(Locale.ROOT, "%s: %s, %d %s, %.2f s", name,
                figures(summary.recording().events(), summary.eventsWithFlow(), summary.eventsPerSecond()),
                segments, segments == 1 ? "segment" : "segments", summary.seconds().wall()));
        }
    }

    private static String figures(long events, long eventsWithFlow, double eventsPerSecond) {
        double share = events == 0 ? 0 : 100.0 * eventsWithFlow / events;
        return String.format(Locale.ROOT, "%d events, %.1f %% with flow, %.0f events/s", events, share,
            eventsPerSecond);
    }

    /** Shows a line, above the bar where there is one. */
    synchronized void say(String line) {
        clear();
        err.println(line);
    }

    /** Wipes the bar's line until it is drawn again. */
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
