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
 * Labels packets on a thread of its own, in order and every one, so that one that takes long does not stop the viewer.
 * At most {@value #MOST_BEHIND} are not labelled yet when the viewer goes on. For one thread at a time, that of the
 * packets; what is done with a packet right after it was labelled is done on the engine's.
 */
final class Engine {
    /** More would show flow that is old; with fewer a long packet would stop the viewer. */
    static final int MOST_BEHIND = 2;
    /** Half of a picture's time at 60 a second: what is ready by then is shown with its own packet. */
    private static final long PATIENCE_MS = 8;
    private static final long IDLE_S = 10;

    private final Sofas sofas;
    private final Consumer<LabelledPacket> labelled;
    private final ThreadPoolExecutor thread;
    private final ArrayDeque<Future<LabelledPacket>> pending = new ArrayDeque<>();
    private final ArrayDeque<LabelledPacket> free = new ArrayDeque<>();
    /** Whether none was behind when the last packet came: else waiting for that one would slow both down. */
    private boolean caughtUp;

    /**
     * Makes an engine.
     *
     * @param ended gets segments that end
     * @param labelled gets each packet when it is labelled
     */
    Engine(SensorSize sensor, SofasParameters parameters, Consumer<Segment> ended, Consumer<LabelledPacket> labelled) {
        sofas = new Sofas(sensor, parameters, ended);
        this.labelled = labelled;
        thread = new ThreadPoolExecutor(1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread made = new Thread(task, "SOFAS engine");
            made.setDaemon(true);
            return made;
        });
        // a filter that was removed leaves no thread behind
        thread.allowCoreThreadTimeOut(true);
    }

    Sofas sofas() {
        return sofas;
    }

    /** A packet to be filled. */
    LabelledPacket take() {
        return free.isEmpty() ? new LabelledPacket() : free.pop();
    }

    /** Gives back a packet that is not needed any more. */
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

    /** How many packets are not handed out yet. */
    int behind() {
        return pending.size();
    }

    /**
     * The oldest packet that was submitted, when it is labelled; null where there is none, or none yet.
     *
     * @param wait whether to wait for it; without it only where too many are behind, and a little where none was
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
