package io.github.sofas.spark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.Test;

public class RunningTasksTest {
    private final RunningTasks tasks = new RunningTasks();

    @Test
    public void stopWaitsForWhatRuns() throws Exception {
        tasks.begin();
        tasks.begin();
        AtomicBoolean over = new AtomicBoolean();
        CountDownLatch began = new CountDownLatch(1);
        Thread other = new Thread(() -> {
            began.countDown();
            tasks.end();
            over.set(true);
            tasks.end();
        });
        other.start();
        assertTrue(began.await(10, TimeUnit.SECONDS));
        tasks.stop(10);
        assertTrue(over.get());
        other.join();
    }

    @Test
    public void nothingBeginsAfterStop() {
        tasks.stop(10);
        assertEquals("told to stop", assertThrows(InterruptedException.class, tasks::begin).getMessage());
    }

    @Test
    public void stopGivesUpOnWhatDoesNotEnd() throws Exception {
        tasks.begin();
        tasks.stop(0);
        assertThrows(InterruptedException.class, tasks::begin);
    }
}
