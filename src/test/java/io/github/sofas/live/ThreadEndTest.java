package io.github.sofas.live;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.CountDownLatch;
import org.junit.Test;

public class ThreadEndTest {
    @Test
    public void interruptIsKeptUntilTheThreadHasEnded() throws InterruptedException {
        CountDownLatch mayEnd = new CountDownLatch(1);
        Thread awaited = new Thread(() -> {
            try {
                mayEnd.await();
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        awaited.start();
        boolean[] wasInterruptedAtTheEnd = new boolean[1];
        Thread waiting = new Thread(() -> {
            ThreadEnd.await(awaited);
            wasInterruptedAtTheEnd[0] = !awaited.isAlive() && Thread.currentThread().isInterrupted();
        });
        waiting.start();
        waiting.interrupt();
        waiting.join(50);
        assertTrue("must wait on", waiting.isAlive());
        mayEnd.countDown();
        waiting.join();
        assertFalse(awaited.isAlive());
        assertTrue(wasInterruptedAtTheEnd[0]);
    }
}
