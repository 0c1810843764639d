package io.github.sofas.jaer;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayDeque;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;

/**
 * Labels packets on a thread of its own, so that a packet that takes long does not stop the viewer. It labels every
 * packet, and in order. At most {@value #MOST_BEHIND} packets are not labelled yet when the viewer continues. One
 * thread at a time uses this class, the thread of the packets. The consumer of labelled packets is called on the
 * engine's thread.
 */
final class Engine {
    /** With more, pictures would show old flow; with fewer, a long packet would stop the viewer. */
    static final int MOST_BEHIND = 2;
    /** Half of a picture's time at 60 pictures per second: flow that is ready by then is shown with its own packet. */
    private static final long PATIENCE_MS = 8;
    private static final long IDLE_S = 10;

    private final Sofas sofas;
    private final Consumer<LabelledPacket> labelled;
    private final ThreadPoolExecutor thread;
    private final ArrayDeque<Future<LabelledPacket>> pending = new ArrayDeque<>();
    private final ArrayDeque<LabelledPacket> free = new ArrayDeque<>();
    /**
     * Whether no packet was behind when the last one came. Otherwise, waiting for that one would slow both threads
     * down.
     */
    private boolean caughtUp;

    /**
     * Makes an engine.
     *
     * @param ended receives segments that end
     * @param labelled receives each packet when it is labelled
     */
    Engine(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended, Consumer<LabelledPacket> labelled) {
        sofas = new Sofas(sensor, parameters, ended);
        this.labelled = labelled;
        thread = new ThreadPoolExecutor(1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread made = new Thread(task, "SOFAS engine");
            made.setDaemon(true);
            return made;
        });
        // a filter that is removed leaves no thread behind
        thread.allowCoreThreadTimeOut(true);
    }

    Sofas sofas() {
        return sofas;
    }

    /** A packet to be filled. */
    LabelledPacket take() {
        return free.isEmpty() ? new LabelledPacket() : free.pop();
    }

    /** Returns a packet that is not needed any more, for reuse. */
    void giveBack(LabelledPacket packet) {
        free.push(packet);
    }

    void submit(LabelledPacket packet) {
        caughtUp = pending.isEmpty();
        pending.add(thread.submit(() -> label(packet), packet));
    }

    private void label(LabelledPacket packet) {
        long start = System.nanoTime();
        sofas.process(packet.batch(), packet.flow());
        packet.setEngineNs(System.nanoTime() - start);
        labelled.accept(packet);
    }

    /** Number of packets that {@link #next} has not handed out yet. */
    int behind() {
        return pending.size();
    }

    /**
     * The oldest packet that was submitted, once it is labelled; null if there is none, or if it is not labelled yet.
     *
     * @param wait whether to wait for the packet; if not, this waits only if too many packets are behind, and briefly
     *     if none was
     */
    LabelledPacket next(boolean wait) {
        if (pending.isEmpty()) {
            return null;
        }
        try {
            Future<LabelledPacket> oldest = pending.peek();
            LabelledPacket packet = wait || oldest.isDone() || pending.size() > MOST_BEHIND ? oldest.get()
                : oldest.get(caughtUp ? PATIENCE_MS : 0, TimeUnit.MILLISECONDS);
            pending.remove();
            return packet;
        } catch (TimeoutException e) {
            return null;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return null;
        } catch (ExecutionException e) {
            pending.remove();
            throw new IllegalStateException(e.getCause());
        }
    }

    /** Waits until all packets are labelled; they are handed out afterwards. */
    void await() {
        for (Future<LabelledPacket> each : pending) {
            try {
                each.get();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
            } catch (ExecutionException e) {
                throw new IllegalStateException(e.getCause());
            }
        }
    }

    /** Forgets all events and segments, and packets that were not handed out. */
    void reset() {
        for (LabelledPacket packet = next(true); packet != null; packet = next(true)) {
            giveBack(packet);
        }
        sofas.reset();
    }
}
