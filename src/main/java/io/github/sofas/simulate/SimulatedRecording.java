package io.github.sofas.simulate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.SensorSize;
import java.util.Arrays;

/**
 * A whole filmed scene in memory: its events in order of time, each with its truth. The events are in parallel arrays
 * of exactly {@link #size()} entries.
 */
public final class SimulatedRecording {
    private static final int BATCH = 8192;

    /** Time of each event in µs, never decreasing. */
    public final long[] timeUs;
    /** Column of each event. */
    public final short[] x;
    /** Row of each event. */
    public final short[] y;
    /** Polarity of each event: +1 ON, -1 OFF. */
    public final byte[] polarity;
    /** True velocity to the right in px/s; 0 for noise. */
    public final float[] vxPxPerS;
    /** True velocity downwards in px/s; 0 for noise. */
    public final float[] vyPxPerS;
    /** Number of the object that caused the event, from 1; 0 for noise. */
    public final int[] object;

    private final SensorSize sensor;
    private final long durationUs;
    private final int objects;

    private SimulatedRecording(SimulatedSource source) {
        sensor = source.sensor();
        durationUs = source.durationUs();
        objects = source.objects();
        EventBatch batch = new EventBatch(BATCH);
        Truth truth = new Truth(BATCH);
        long[] times = new long[BATCH];
        short[] columns = new short[BATCH];
        short[] rows = new short[BATCH];
        byte[] signs = new byte[BATCH];
        float[] vx = new float[BATCH];
        float[] vy = new float[BATCH];
        int[] causes = new int[BATCH];
        int size = 0;
        while (source.next(batch, truth)) {
            int more = batch.size();
            if (size + more > times.length) {
                int capacity = Math.max(size + more, 2 * times.length);
                times = Arrays.copyOf(times, capacity);
                columns = Arrays.copyOf(columns, capacity);
                rows = Arrays.copyOf(rows, capacity);
                signs = Arrays.copyOf(signs, capacity);
                vx = Arrays.copyOf(vx, capacity);
                vy = Arrays.copyOf(vy, capacity);
                causes = Arrays.copyOf(causes, capacity);
            }
            System.arraycopy(batch.timeUs, 0, times, size, more);
            System.arraycopy(batch.x, 0, columns, size, more);
            System.arraycopy(batch.y, 0, rows, size, more);
            System.arraycopy(batch.polarity, 0, signs, size, more);
            System.arraycopy(truth.vxPxPerS, 0, vx, size, more);
            System.arraycopy(truth.vyPxPerS, 0, vy, size, more);
            System.arraycopy(truth.object, 0, causes, size, more);
            size += more;
        }
        timeUs = Arrays.copyOf(times, size);
        x = Arrays.copyOf(columns, size);
        y = Arrays.copyOf(rows, size);
        polarity = Arrays.copyOf(signs, size);
        vxPxPerS = Arrays.copyOf(vx, size);
        vyPxPerS = Arrays.copyOf(vy, size);
        object = Arrays.copyOf(causes, size);
    }

    /**
     * Films a scene once and keeps the film.
     *
     * @param scene the scene
     * @param options how the scene is filmed
     * @return the recording
     */
    public static SimulatedRecording of(Scene scene, SimulationOptions options) {
        return new SimulatedRecording(new SimulatedSource(scene, options));
    }

    static SimulatedRecording of(World world, SimulationOptions options) {
        return new SimulatedRecording(new SimulatedSource(world, options, 1));
    }

    /** {@return the pixel array} */
    public SensorSize sensor() {
        return sensor;
    }

    /** {@return the duration of the film in µs; latency can put the last events a little later} */
    public long durationUs() {
        return durationUs;
    }

    /** {@return the number of objects in the scene} */
    public int objects() {
        return objects;
    }

    /** {@return the number of events} */
    public int size() {
        return timeUs.length;
    }

    /** {@return a new source of the events from first to last} */
    public EventSource source() {
        return new Replay();
    }

    private final class Replay implements EventSource {
        private int next;

        @Override
        public SensorSize sensor() {
            return sensor;
        }

        @Override
        public boolean next(EventBatch batch) {
            int count = Math.min(batch.capacity(), size() - next);
            System.arraycopy(timeUs, next, batch.timeUs, 0, count);
            System.arraycopy(x, next, batch.x, 0, count);
            System.arraycopy(y, next, batch.y, 0, count);
            System.arraycopy(polarity, next, batch.polarity, 0, count);
            batch.setSize(count);
            next += count;
            return count > 0;
        }

        @Override
        public void close() {
            next = size();
        }
    }
}
