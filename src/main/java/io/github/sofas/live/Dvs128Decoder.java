package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.JaerAddress;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Decodes the stream of a DVS128 into events. Each event has 4 bytes: an address as jAER writes it, then a time, both
 * little-endian words of 16 bits. Two bits of the time mark wraps and resets of the camera's time.
 */
final class Dvs128Decoder implements CameraDecoder {
    private static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class,
        ByteOrder.LITTLE_ENDIAN);
    private static final int EVENT_BYTES = 4;
    private static final int WRAP = 0x8000;
    private static final int TIME_RESET = 0x4000;
    private static final int TIME_MASK = 0x3FFF;
    private static final long WRAP_US = 0x4000;

    private final JaerAddress addresses;
    private final CameraClock clock = new CameraClock(WRAP_US);

    private long triggers;
    private long oddBytes;

    Dvs128Decoder(JaerAddress addresses) {
        this.addresses = addresses;
    }

    @Override
    public int mostEvents(int bytes) {
        return bytes / EVENT_BYTES;
    }

    @Override
    public void decode(byte[] data, int length, EventBatch batch) {
        oddBytes += length % EVENT_BYTES;
        for (int p = 0; p + EVENT_BYTES <= length; p += EVENT_BYTES) {
            int time = (short) SHORT.get(data, p + Short.BYTES);
            if ((time & WRAP) != 0) {
                clock.wrap(1);
                continue;
            }
            if ((time & TIME_RESET) != 0) {
                clock.reset();
                continue;
            }
            int address = (short) SHORT.get(data, p) & 0xFFFF;
            long timeUs = clock.extend(time & TIME_MASK);
            if (addresses.isEvent(address)) {
                batch.add(timeUs, addresses.x(address), addresses.y(address), addresses.polarity(address));
            } else {
                triggers++;
            }
        }
    }

    @Override
    public void lose() {
        clock.lose();
    }

    @Override
    public Map<String, Long> counts() {
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("triggers", triggers);
        counts.put("steps_back_in_time", clock.stepsBack);
        counts.put("time_wraps", clock.wraps);
        counts.put("time_resets", clock.resets);
        counts.put("odd_bytes", oddBytes);
        return counts;
    }

    @Override
    public Map<String, Long> dropped() {
        // x and y have 7 bits each: no event lies outside the sensor.
        return Map.of();
    }
}
