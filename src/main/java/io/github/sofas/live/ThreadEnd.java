package io.github.sofas.live;

/** The end of a thread whose buffers, socket or file must not go before it. */
public final class ThreadEnd {
    private ThreadEnd() {
    }

    /**
     * Waits for a thread to end, however often the caller is interrupted meanwhile, and leaves it interrupted then.
     *
     * @param thread that is to end
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
