package io.github.sofas;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Hours of a live camera in minutes: shows one engine all simulated scenes again and again, from a new direction each
 * time, and prints heap, latency and speed. They must not grow. {@code ./gradlew soak -PsoakEvents=100000000}
 */
public final class Soak {
    private static final int BATCH = 4096;
    private static final long PAUSE_US = 200_000;
    private static final int LINES = 20;
    private static final int DIRECTIONS = 3;

    private final Sofas sofas;
    private final EventBatch batch = new EventBatch(BATCH);
    private final FlowOutput flow = new FlowOutput(BATCH);
    private final long[] batchNs;
    private int batches;
    private long nowUs;
    private long events;
    private long withFlow;
    private long ended;

    private Soak(long eventsPerLine) {
        sofas = new Sofas(SimulationOptions.defaults().sensor(), SofasParameters.defaults(), segment -> ended++);
        batchNs = new long[(int) (eventsPerLine / BATCH * 2) + 1000];
    }

    /** Runs; the argument is how many events, a thousand million where there is none. */
    public static void main(String[] args) {
        long most = args.length > 0 ? Long.parseLong(args[0]) : 1_000_000_000L;
        List<SimulatedRecording> films = new ArrayList<>();
        for (int i = 0; i < DIRECTIONS; i++) {
            for (Scene scene : Scene.values()) {
                films.add(SimulatedRecording.of(scene, SimulationOptions.defaults().withDirectionDeg(i * 50)
                    .withSeed(i + 1)));
            }
        }
        System.out.println("     events  events/s  with flow  segments  heap MB  batch of " + BATCH
            + " in us: median, 99 %, longest");
        new Soak(most / LINES).run(films, most);
    }

    private void run(List<SimulatedRecording> films, long most) {
        long startNs = System.nanoTime();
        long startEvents = 0;
        long startWithFlow = 0;
        for (int shown = 0; events < most; shown++) {
            show(films.get(shown % films.size()));
            if (events - startEvents >= most / LINES || events >= most) {
                double seconds = (System.nanoTime() - startNs) / 1e9;
                double share = 100.0 * (withFlow - startWithFlow) / (events - startEvents);
                print((events - startEvents) / seconds, share);
                startNs = System.nanoTime();
                startEvents = events;
                startWithFlow = withFlow;
                batches = 0;
            }
        }
    }

    /** Shows a film, after a pause in time. */
    private void show(SimulatedRecording film) {
        long offsetUs = nowUs + PAUSE_US - film.timeUs[0];
        for (int from = 0; from < film.size(); from += BATCH) {
            int size = Math.min(BATCH, film.size() - from);
            for (int i = 0; i < size; i++) {
                batch.timeUs[i] = film.timeUs[from + i] + offsetUs;
            }
            System.arraycopy(film.x, from, batch.x, 0, size);
            System.arraycopy(film.y, from, batch.y, 0, size);
            System.arraycopy(film.polarity, from, batch.polarity, 0, size);
            batch.setSize(size);
            long startNs = System.nanoTime();
            sofas.process(batch, flow);
            if (size == BATCH && batches < batchNs.length) {
                batchNs[batches++] = System.nanoTime() - startNs;
            }
            count(size);
        }
        nowUs = film.timeUs[film.size() - 1] + offsetUs;
    }

    private void count(int size) {
        events += size;
        for (int i = 0; i < size; i++) {
            if (flow.segment[i] != 0) {
                withFlow++;
                if (!Float.isFinite(flow.vxPxPerS[i] + flow.vyPxPerS[i])) {
                    throw new IllegalStateException("event " + (events - size + i) + " has no finite velocity");
                }
            }
        }
    }

    private void print(double eventsPerS, double shareWithFlow) {
        System.gc();
        long heap = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
        Arrays.sort(batchNs, 0, batches);
        System.out.println(String.format(Locale.ROOT, "%11d %9.0f %8.1f %% %9d %8.1f %9d %9d %9d", events, eventsPerS,
            shareWithFlow, ended, heap / 1e6, batchNs[batches / 2] / 1000, batchNs[batches * 99 / 100] / 1000,
            batchNs[batches - 1] / 1000));
    }
}
