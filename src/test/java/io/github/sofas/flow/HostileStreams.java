package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;

/** Events that no scene makes, by what is wrong with them; each stream is one batch, by chance with a fixed seed. */
final class HostileStreams {
    private static final long HOUR_US = 3_600_000_000L;

    /** Makes the event of a number. */
    private interface Maker {
        void add(EventBatch batch, int number, Random random);
    }

    private HostileStreams() {
    }

    static Map<String, EventBatch> all(SensorSize sensor, int events) {
        int w = sensor.width();
        int h = sensor.height();
        int pixels = w * h;
        Map<String, EventBatch> all = new LinkedHashMap<>();
        put(all, "all at one pixel, 12 million a second", events, (b, i, r) -> b.add(i / 12, w / 2, h / 2, 1));
        put(all, "all at four pixels, 12 million a second", events,
            (b, i, r) -> b.add(i / 12, w / 2 + (i & 1), h / 2 + (i >> 1 & 1), 1));
        put(all, "the whole frame at once, ON and OFF", events,
            (b, i, r) -> b.add(i / pixels * 10_000L, i % w, i / w % h, i / pixels % 2 == 0 ? 1 : -1));
        put(all, "the whole frame by chance at one time, ON", events,
            (b, i, r) -> b.add(7, r.nextInt(w), r.nextInt(h), 1));
        put(all, "backwards", events, (b, i, r) -> b.add(-50L * i, i % w, i / w % h, 1));
        put(all, "an edge between jumps of hours", events,
            (b, i, r) -> b.add(i / 1000 * HOUR_US + i % 1000 * 100L, i % 1000 / 20 % w, i % h, 1));
        put(all, "an hour after each other", events, (b, i, r) -> b.add(i * HOUR_US, i % w, i / w % h, 1));
        put(all, "times of 32 bits that wrap", events,
            (b, i, r) -> b.add((int) (i * 1_000_003L), i / 7 % w, i % h, 1));
        put(all, "an edge in negative time", events,
            (b, i, r) -> b.add(-HOUR_US + i * 20L, i / 40 % w, i % h, 1));
        put(all, "from the first time there is to the last", events,
            (b, i, r) -> b.add(i < events / 2 ? Long.MIN_VALUE + i * 20L : Long.MAX_VALUE - (events - i) * 20L,
                i / 40 % w, i % h, 1));
        put(all, "times by chance", events, (b, i, r) -> b.add(r.nextLong(), r.nextInt(w), r.nextInt(h), 1));
        put(all, "addresses outside", events,
            (b, i, r) -> b.add(i * 20L, (short) r.nextInt(), (short) r.nextInt(), 1));
        put(all, "an edge among addresses outside", events, (b, i, r) -> b.add(i * 20L,
            i % 2 == 0 ? i / 80 % w : r.nextInt(4 * w) - 2 * w, i % 2 == 0 ? i / 2 % h : h + r.nextInt(h), 1));
        put(all, "a dense texture, 12 million a second", events,
            (b, i, r) -> b.add(i / 12, (r.nextInt(w / 4) * 4 + i / 12 / 500) % w, r.nextInt(h), r.nextInt(2)));
        put(all, "bursts of 12 million a second", events,
            (b, i, r) -> b.add(i / 6000 * 1_000_000L + i % 6000 / 12, (i / 6000 + i % 6) % w, i / 6 % h, i & 1));
        put(all, "hours of noise", events,
            (b, i, r) -> b.add(i * (10 * HOUR_US / events), r.nextInt(w), r.nextInt(h), r.nextInt(2)));
        put(all, "noise, one event a pixel and second", events,
            (b, i, r) -> b.add(i * 1_000_000L / pixels, r.nextInt(w), r.nextInt(h), r.nextInt(2)));
        all.put("structures wherever there is room", structures(sensor, events));
        put(all, "an edge at 50,000 px/s", events, (b, i, r) -> b.add(i, i / 20 % w, i % h, 1));
        put(all, "an edge at half a pixel a second", events,
            (b, i, r) -> b.add(i * 2_000_000L / h, i / h % w, i % h, 1));
        put(all, "an edge that turns round with each column", events,
            (b, i, r) -> b.add(i * 50L, w / 2 + i / h % 2 * 3, i % h, i / h % 2));
        return all;
    }

    /** A dot each 4 px, up, down, left or right at 100 px/s. */
    static EventBatch structures(SensorSize sensor, int events) {
        int w = sensor.width();
        int h = sensor.height();
        int dots = (w / 4) * (h / 4);
        EventBatch batch = new EventBatch(events);
        for (int i = 0; i < events; i++) {
            int dot = i % dots;
            int step = i / dots;
            int direction = dot * 7 % 4;
            int x = dot % (w / 4) * 4 + (direction == 0 ? step : direction == 1 ? -step : 0);
            int y = dot / (w / 4) * 4 + (direction == 2 ? step : direction == 3 ? -step : 0);
            batch.add(step * 10_000L + dot % 100, Math.floorMod(x, w), Math.floorMod(y, h), dot & 1);
        }
        return batch;
    }

    private static void put(Map<String, EventBatch> all, String name, int events, Maker maker) {
        EventBatch batch = new EventBatch(events);
        Random random = new Random(name.hashCode());
        for (int i = 0; i < events; i++) {
            maker.add(batch, i, random);
        }
        all.put(name, batch);
    }
}
