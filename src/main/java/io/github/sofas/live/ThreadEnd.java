package io.github.sofas.live;

/** Waits for the end of a thread, before its buffers, socket or file are released. */
public final class ThreadEnd {
    private ThreadEnd() {
    }

    /**
     * Waits for a thread to end, however often the caller is interrupted meanwhile. The caller is left interrupted
     * then.
     *
     * @param thread the thread that is to end
     */
    public static void await(Thread thread) {
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
