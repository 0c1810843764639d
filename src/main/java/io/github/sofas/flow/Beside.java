package io.github.sofas.flow;

import java.util.function.Consumer;

/**
 * Work that is begun at one time and needed at a later one: in between a helper may do it beside the caller, and what
 * it has not begun by then the caller does itself. So nobody waits for a helper that is busy, or is none.
 */
final class Beside {
    /** How often it is looked whether work is done before the caller sleeps: as long as it takes to be woken. */
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

    /** Has another helper from the next time on; null for none. */
    void helpedBy(Consumer<Runnable> newHelper) {
        helper = newHelper;
    }

    /** Begins the work, once what was begun before is over; without a helper the caller does it at once. */
    void begin() {
        if (helper == null) {
            work.run();
            return;
        }
        state = State.OFFERED;
        helper.accept(help);
    }

    private void help() {
        // late where the caller did not wait: then there may be work of another time, or none
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
                // labels do not depend on it: told to the caller afterwards
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
