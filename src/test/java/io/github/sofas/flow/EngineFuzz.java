package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The engine, with any parameters and events: no exception, every velocity finite, every structure on the sensor. Bytes
 * are the preset, the sensor, changes of parameters, then events of five bytes.
 */
public final class EngineFuzz {
    private static final long MOST_BYTES = 100_000_000;
    private static final int EVENT_BYTES = 5;
    private static final int BATCH = 100;

    private EngineFuzz() {
    }

    /** Called by the fuzzer. */
    public static void fuzzerTestOneInput(byte[] data) {
        ByteBuffer in = ByteBuffer.wrap(data);
        if (in.remaining() < 4) {
            return;
        }
        SofasParameters p = in.get() < 0 ? SofasParameters.paper() : SofasParameters.defaults();
        SensorSize sensor = new SensorSize(1 + (in.get() & 0x7F), 1 + (in.get() & 0x7F));
        for (int changes = in.get() & 7; changes > 0 && in.remaining() >= 2; changes--) {
            p = changed(p, in.get() & 0xFF, (in.get() & 0xFF) / 255.0);
        }
        // few planes, so that the bound lets the other parameters go far
        p = p.with("maxTrackPlanes", Math.min(p.track().maxTrackPlanes(), 3));
        if (Sofas.mostBytes(sensor, p) < MOST_BYTES) {
            run(sensor, p, in);
        }
    }

    /** A parameter at a place of its range, the ends included; the same where it contradicts another. */
    private static SofasParameters changed(SofasParameters p, int which, double place) {
        ParameterHandle handle = ParameterHandle.all().get(which % ParameterHandle.all().size());
        if (handle.isSwitch()) {
            return p.with(handle.name(), place > 0.5);
        }
        // more of the small values than of the large ones
        Parameter range = handle.declaration();
        double value = range.min() + (range.max() - range.min()) * place * place * place;
        try {
            return p.with(handle.name(), handle.isWhole() ? Math.floor(value) : value);
        } catch (IllegalArgumentException e) {
            return p;
        }
    }

    private static void run(SensorSize sensor, SofasParameters p, ByteBuffer in) {
        List<Segment> ended = new ArrayList<>();
        Sofas sofas = new Sofas(sensor, p, ended::add);
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        long timeUs = 0;
        while (in.remaining() >= EVENT_BYTES) {
            batch.clear();
            while (!batch.isFull() && in.remaining() >= EVENT_BYTES) {
                int step = in.get();
                // steps from 1 to 2^62 us, forwards and backwards
                timeUs += step >= 0 ? step : 1L << (step & 0x3F);
                int x = in.get();
                int y = in.get();
                int row = in.get() & 7;
                // a run of events, so that few bytes make a structure
                for (int i = in.get() & 15; i >= 0 && !batch.isFull(); i--) {
                    batch.add(timeUs, x, y + i * (row & 1), row > 3 ? 1 : -1);
                }
            }
            sofas.process(batch, output);
            check(sensor, batch, output, sofas.segments());
        }
        sofas.reset();
        check(sensor, batch, output, ended);
    }

    private static void check(SensorSize sensor, EventBatch batch, FlowOutput output, List<Segment> segments) {
        for (int i = 0; i < batch.size(); i++) {
            if (!Float.isFinite(output.vxPxPerS[i]) || !Float.isFinite(output.vyPxPerS[i])) {
                throw new IllegalStateException("a velocity is not finite");
            }
        }
        for (Segment segment : segments) {
            HostileEventsTest.check("fuzzed", segment, sensor);
        }
    }

    /** Valid inputs to start from: an edge, whose events stand a column, for both presets and with changes. */
    public static List<byte[]> seeds() {
        List<byte[]> seeds = new ArrayList<>();
        for (int head : new int[] {0x00404000, 0x80404000, 0x00404001, 0x80404001}) {
            ByteBuffer bytes = ByteBuffer.allocate(1000).putInt(head);
            if ((head & 1) == 1) {
                bytes.put((byte) 5).put((byte) 100);
            }
            for (int i = 0; i < 60; i++) {
                bytes.put((byte) 120).put((byte) (i / 2)).put((byte) 10).put((byte) 5).put((byte) 15);
                bytes.put((byte) 120).put((byte) (i / 2)).put((byte) 26).put((byte) 5).put((byte) 15);
            }
            seeds.add(Arrays.copyOf(bytes.array(), bytes.position()));
        }
        return seeds;
    }
}
