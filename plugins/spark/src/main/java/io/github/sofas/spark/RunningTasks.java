package io.github.sofas.spark;

import java.util.concurrent.TimeUnit;

/**
 * Counts the tasks that run in this process; with a local master, these are all running tasks. Spark ends a local batch
 * without waiting for its tasks, so that files which a task still writes would be left behind. {@link #stop} waits for
 * them.
 */
final class RunningTasks {
    static final RunningTasks HERE = new RunningTasks();

    private int running;
    private boolean stopped;

    /**
     * Notes that a task begins.
     *
     * @throws InterruptedException if no task may begin any more
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

    /** Allows no further task to begin, and waits until none runs, but at most that many s. */
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
