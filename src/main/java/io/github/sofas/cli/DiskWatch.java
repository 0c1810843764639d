package io.github.sofas.cli;

import java.util.Locale;
import java.util.function.LongSupplier;

/** Warns before a disk is full: a capture cannot be repeated. */
final class DiskWatch {
    private static final double WARNED_S = 60;
    private static final long PAUSE_NS = 10_000_000_000L;

    private final String place;
    private final LongSupplier freeBytes;
    private final LongSupplier writtenBytes;
    private final LongSupplier clockNs;
    private long lastNs;
    private long lastWritten;
    private long warnedNs;
    private boolean warned;

    /**
     * Makes one.
     *
     * @param place on the disk, for the message
     * @param freeBytes tells how much room is left
     * @param writtenBytes tells how much was written
     * @param clockNs tells the time
     */
    DiskWatch(String place, LongSupplier freeBytes, LongSupplier writtenBytes, LongSupplier clockNs) {
        this.place = place;
        this.freeBytes = freeBytes;
        this.writtenBytes = writtenBytes;
        this.clockNs = clockNs;
        lastNs = clockNs.getAsLong();
    }

    /** What there is to say now, asked about once a second; null for nothing. */
    String warning() {
        long now = clockNs.getAsLong();
        long written = writtenBytes.getAsLong();
        double bytesPerS = (written - lastWritten) / Math.max(1e-3, (now - lastNs) / 1e9);
        lastNs = now;
        lastWritten = written;
        long free = freeBytes.getAsLong();
        if (bytesPerS <= 0 || free / bytesPerS > WARNED_S || warned && now - warnedNs < PAUSE_NS) {
            return null;
        }
        warned = true;
        warnedNs = now;
        return String.format(Locale.ROOT, "[%s] %.0f MB are left on this disk, for about %.0f s", place, free / 1e6,
            free / bytesPerS);
    }
}
