package io.github.sofas.cli;

import java.util.Locale;
import java.util.function.LongSupplier;

/** Warns, at most every 10 s, when a disk will be full within a minute: a capture cannot be repeated. */
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
     * Starts watching a disk.
     *
     * @param place a path on the disk, for the message
     * @param freeBytes supplies the number of bytes left on the disk
     * @param writtenBytes supplies the number of bytes written so far
     * @param clockNs supplies the time in ns
     */
    DiskWatch(String place, LongSupplier freeBytes, LongSupplier writtenBytes, LongSupplier clockNs) {
        this.place = place;
        this.freeBytes = freeBytes;
        this.writtenBytes = writtenBytes;
        this.clockNs = clockNs;
        lastNs = clockNs.getAsLong();
    }

    /** The warning that is due now, null if there is none; called about once per second. */
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
