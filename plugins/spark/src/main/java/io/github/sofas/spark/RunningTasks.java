package io.github.sofas.spark;

import java.util.concurrent.TimeUnit;

/**
 * The tasks that run in this process: with a local master all that run. Spark ends a local batch without waiting for
 * them, and what one of them still writes would be left behind.
 */
final class RunningTasks {
    static final RunningTasks HERE = new RunningTasks();

    private int running;
    private boolean stopped;

    /**
     * Notes that a task begins.
     *
     * @throws InterruptedException where none is to begin any more
     */
    synchronized void begin() throws InterruptedException {
        if (stopped) {
            throw new InterruptedException("told to stop");
        }
        running++;
    }

    /** Notes that a task that began has ended. */
    synchronized void end() {
        running--;
        notifyAll();
    }

    /** Lets no task begin any more, and waits until none runs, but no longer than some seconds. */
    synchronized void stop(int mostS) {
        stopped = true;
        long untilNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(mostS);
        try {
            for (long leftNs; running > 0 && (leftNs = untilNs - System.nanoTime()) > 0;) {
                TimeUnit.NANOSECONDS.timedWait(this, leftNs);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
