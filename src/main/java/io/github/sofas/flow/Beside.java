package io.github.sofas.flow;

import java.util.function.Consumer;

/**
 * Work that is begun at one time and whose result is needed later. In between, a helper may do it beside the caller; if
 * the helper has not begun it by then, the caller does it. So nobody waits for a helper that is busy or absent.
 */
final class Beside {
    /** Times that the caller checks whether the work is done before it sleeps: about as long as waking up takes. */
    private static final int LOOKS = 20_000;

    private enum State { DONE, OFFERED, WORKING }

    private final Runnable work;
    private final Runnable help = this::help;
    private volatile State state = State.DONE;
    private Throwable failure;
    private Consumer<Runnable> helper;

    Beside(Runnable work) {
        this.work = work;
    }

    /** Uses another helper from the next time on; null for none. */
    void helpedBy(Consumer<Runnable> newHelper) {
        helper = newHelper;
    }

    /** Begins the work, once the work begun before is over; without a helper, the caller does it at once. */
    void begin() {
        if (helper == null) {
            work.run();
            return;
        }
        state = State.OFFERED;
        helper.accept(help);
    }

    private void help() {
        // a late helper may find no work, because the caller did not wait, or work that was begun later
        if (claims()) {
            try {
                work.run();
            } catch (RuntimeException | Error e) {
                failure = e;
            } finally {
                end();
            }
        }
    }

    private synchronized boolean claims() {
        boolean isOffered = state == State.OFFERED;
        if (isOffered) {
            state = State.WORKING;
        }
        return isOffered;
    }

    private synchronized void end() {
        state = State.DONE;
        notifyAll();
    }

    /** Returns once the work is done; throws what it threw. */
    void await() {
        if (state == State.DONE && failure == null) {
            return;
        }
        if (claims()) {
            state = State.DONE;
            work.run();
            return;
        }
        for (int i = 0; i < LOOKS && state != State.DONE; i++) {
            Thread.onSpinWait();
        }
        sleep();
        Throwable thrown = failure;
        failure = null;
        if (thrown instanceof Error) {
            throw (Error) thrown;
        } else if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }

    private synchronized void sleep() {
        boolean interrupted = false;
        while (state != State.DONE) {
            try {
                wait();
            } catch (InterruptedException e) {
                // labels do not depend on it: the caller is interrupted afterwards
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
