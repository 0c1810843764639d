package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.Test;

/** Who does work that a helper may do. */
public class BesideTest {
    private final List<Thread> workers = new ArrayList<>();
    private final Beside beside = new Beside(() -> workers.add(Thread.currentThread()));

    @Test
    public void withoutAHelperTheCallerWorksAtOnce() {
        beside.begin();
        assertEquals(List.of(Thread.currentThread()), workers);
        beside.await();
        assertEquals(1, workers.size());
    }

    @Test
    public void whatNoHelperBeganTheCallerDoesWhenItIsNeeded() {
        List<Runnable> asked = new ArrayList<>();
        beside.helpedBy(asked::add);
        beside.begin();
        assertEquals(List.of(), workers);
        beside.await();
        assertEquals(List.of(Thread.currentThread()), workers);
        // the helper comes late, and finds nothing to do
        asked.forEach(Runnable::run);
        assertEquals(1, workers.size());
    }

    @Test
    public void lateHelperDoesTheNextWorkOnce() {
        List<Runnable> asked = new ArrayList<>();
        beside.helpedBy(asked::add);
        beside.begin();
        beside.await();
        beside.begin();
        asked.get(0).run();
        assertEquals(2, workers.size());
        asked.get(1).run();
        beside.await();
        assertEquals(2, workers.size());
    }

    @Test
    public void callerWaitsForAHelperThatHasBegun() throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch mayEnd = new CountDownLatch(1);
        Beside slow = new Beside(() -> {
            begun.countDown();
            awaitQuietly(mayEnd);
            workers.add(Thread.currentThread());
        });
        slow.helpedBy(work -> new Thread(work).start());
        slow.begin();
        begun.await();
        new Thread(() -> {
            // longer than the caller looks before it sleeps
            awaitMs(100);
            mayEnd.countDown();
        }).start();
        slow.await();
        assertEquals(1, workers.size());
        assertNotEquals(Thread.currentThread(), workers.get(0));
    }

    @Test
    public void callerThatIsInterruptedWaitsAllTheSame() throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        Beside slow = new Beside(() -> {
            begun.countDown();
            awaitMs(100);
            workers.add(Thread.currentThread());
        });
        slow.helpedBy(work -> new Thread(work).start());
        slow.begin();
        begun.await();
        Thread.currentThread().interrupt();
        slow.await();
        assertEquals(1, workers.size());
        assertTrue("told of it", Thread.interrupted());
    }

    @Test
    public void whatAHelperFailsWithTheCallerGets() throws InterruptedException {
        IllegalStateException fault = new IllegalStateException("no room");
        Beside failing = new Beside(() -> {
            throw fault;
        });
        List<Runnable> asked = new ArrayList<>();
        failing.helpedBy(asked::add);
        failing.begin();
        Thread helper = new Thread(asked.get(0));
        helper.start();
        helper.join();
        assertSame(fault, assertThrows(IllegalStateException.class, failing::await));
        // told once
        failing.await();
    }

    private static void awaitQuietly(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private static void awaitMs(long ms) {
        try {
            Thread.sleep(ms);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
