package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import org.junit.Test;

public class DiskWatchTest {
    private long free = 1_000_000_000;
    private long written;
    private long nowNs;

    private String afterASecond(DiskWatch watch, long bytes) {
        nowNs += 1_000_000_000;
        written += bytes;
        free -= bytes;
        return watch.warning();
    }

    /** 10 MB a second leave 1 GB for 100 s: after 40 s they leave it for 60 s. */
    @Test
    public void warnsAMinuteBeforeTheEndAndThenEveryTenSeconds() {
        DiskWatch watch = new DiskWatch("out", () -> free, () -> written, () -> nowNs);
        for (int second = 1; second < 40; second++) {
            assertNull("after " + second + " s", afterASecond(watch, 10_000_000));
        }
        assertEquals("[out] 600 MB are left on this disk, for about 60 s", afterASecond(watch, 10_000_000));
        for (int second = 41; second < 50; second++) {
            assertNull("after " + second + " s", afterASecond(watch, 10_000_000));
        }
        assertEquals("[out] 500 MB are left on this disk, for about 50 s", afterASecond(watch, 10_000_000));
        assertNull("what does not grow needs no room", afterASecond(watch, 0));
    }
}
