package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;

/**
 * A number that changes if any result changes: a 64-bit checksum after FNV-1a, with one step per value. It does not
 * depend on how events are cut into batches.
 */
final class Checksum {
    private static final long BASIS = 0xcbf29ce484222325L;
    private static final long PRIME = 0x100000001b3L;

    private long sum = BASIS;

    private void add(long value) {
        // The high half is folded in because a product only carries upwards.
        sum = (sum ^ value ^ value >>> 32) * PRIME;
        sum ^= sum >>> 29;
    }

    void add(EventBatch batch) {
        for (int i = 0; i < batch.size(); i++) {
            add(batch.timeUs[i]);
            add(batch.x[i]);
            add(batch.y[i]);
            add(batch.polarity[i]);
        }
    }

    void add(FlowOutput flow, int size) {
        for (int i = 0; i < size; i++) {
            add(flow.segment[i]);
            add(Float.floatToIntBits(flow.vxPxPerS[i]));
            add(Float.floatToIntBits(flow.vyPxPerS[i]));
        }
    }

    void add(byte[] bytes, int from, int length) {
        for (int i = from; i < from + length; i++) {
            add(bytes[i]);
        }
    }

    long value() {
        return sum;
    }
}
