package io.github.sofas.live;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Bytes that a DAVIS240C might send, with everything that may be among them, and the events that are in them: rows with
 * one column or several, times that wrap, intensity and inertial samples, triggers, addresses outside.
 */
final class DavisStream {
    private static final int WIDTH = 240;
    private static final int HEIGHT = 180;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final List<Event> events = new ArrayList<>();
    private final Random random;
    private long timeUs;
    private long wraps;

    /**
     * One event of the stream.
     *
     * @param row where its row's word ends in the stream, in bytes
     * @param end where it ends itself
     * @param text as a row of a flow file begins
     */
    record Event(int row, int end, String text) {
    }

    /** Some events at random pixels, so many µs apart on average. */
    DavisStream(long seed, int count, int stepUs) {
        random = new Random(seed);
        while (events.size() < count) {
            pass(1 + random.nextInt(2 * stepUs));
            other();
            int y = random.nextInt(HEIGHT);
            word(0x1000 | y);
            int row = bytes.size();
            for (int columns = 1 + random.nextInt(3); columns > 0 && events.size() < count; columns--) {
                int x = random.nextInt(WIDTH);
                int on = random.nextInt(2);
                word(0x2000 | on << 12 | x);
                events.add(new Event(row, bytes.size(), timeUs + "," + x + "," + y + "," + (2 * on - 1)));
            }
        }
    }

    private void word(int word) {
        bytes.write(word);
        bytes.write(word >> 8);
    }

    private void pass(int us) {
        timeUs += us;
        while (timeUs >> 15 > wraps) {
            wraps++;
            word(0x7001);
        }
        word(0x8000 | (int) (timeUs & 0x7FFF));
    }

    private void other() {
        switch (random.nextInt(40)) {
            case 0 -> word(0x4000 | random.nextInt(0x1000));
            case 1 -> word(0x0002);
            case 2 -> word(0x5000 | random.nextInt(0x100));
            case 3 -> word(0x1000 | HEIGHT);
            case 4 -> word(0x2000 | WIDTH);
            case 5 -> word(0x0008);
            default -> { }
        }
    }

    byte[] bytes() {
        return bytes.toByteArray();
    }

    List<Event> events() {
        return events;
    }
}
