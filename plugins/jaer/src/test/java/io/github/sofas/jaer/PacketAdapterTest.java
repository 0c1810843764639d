package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.event.PolarityEvent.Polarity;
import org.junit.Test;

public class PacketAdapterTest {
    private static final SensorSize SENSOR = new SensorSize(10, 8);

    private final PacketAdapter adapter = new PacketAdapter();
    private final LabelledPacket read = new LabelledPacket();

    private List<String> read(EventPacket<?> packet) {
        adapter.read(packet, SENSOR, read);
        EventBatch batch = read.batch();
        List<String> events = new ArrayList<>();
        for (int i = 0; i < batch.size(); i++) {
            events.add(batch.timeUs[i] + " " + batch.x[i] + " " + batch.y[i] + " " + batch.polarity[i]);
        }
        return events;
    }

    private List<String> times(int... timestamps) {
        EventPacket<BasicEvent> packet = new EventPacket<>();
        for (int timestamp : timestamps) {
            packet.events.add(Packets.event(timestamp, 0, 0, Polarity.On));
        }
        List<String> times = new ArrayList<>();
        for (String event : read(packet)) {
            times.add(event.split(" ")[0]);
        }
        return times;
    }

    @Test
    public void turnsRowsAndNamesPolarity() {
        // 8 rows: row 0 from below is row 7 from above
        assertEquals(List.of("5 1 7 1", "6 9 0 -1"),
            read(Packets.of(Packets.event(5, 1, 0, Polarity.On), Packets.event(6, 9, 7, Polarity.Off))));
    }

    @Test
    public void leavesOutWhatLiesOffTheSensor() {
        assertEquals(List.of(), read(Packets.of(Packets.event(5, 10, 0, Polarity.On),
            Packets.event(5, -1, 0, Polarity.On), Packets.event(5, 0, 8, Polarity.On),
            Packets.event(5, 0, -1, Polarity.On))));
    }

    @Test
    public void leavesOutWhatIsFilteredOutOrSpecialOrNoPolarityEvent() {
        PolarityEvent filteredOut = Packets.event(5, 1, 1, Polarity.On);
        filteredOut.filteredOut = true;
        PolarityEvent special = Packets.event(5, 1, 1, Polarity.On);
        special.special = true;
        assertEquals(List.of(), read(Packets.of(filteredOut, special, new BasicEvent())));
    }

    @Test
    public void leavesOutFramesAndInertialSamples() {
        assertEquals(List.of("10 3 3 1", "13 3 3 1"), read(Packets.mixed()));
    }

    @Test
    public void emptyPacketIsAnEmptyBatch() {
        times(1, 2);
        assertEquals(List.of(), read(Packets.of()));
    }

    @Test
    public void timeGoesOnAcrossTheWrapOf32Bits() {
        assertEquals(List.of("2147483646", "2147483647", "2147483648", "2147483650"),
            times(Integer.MAX_VALUE - 1, Integer.MAX_VALUE, Integer.MIN_VALUE, Integer.MIN_VALUE + 2));
    }

    @Test
    public void smallStepsBackAreHandedOn() {
        assertEquals(List.of("100", "90", "110"), times(100, 90, 110));
    }

    @Test
    public void clockThatIsSetBackIsALongTime() {
        // two minutes pass, then time goes on as the clock does
        assertEquals(List.of("5000000", "125000000", "125000007"), times(5_000_000, 0, 7));
    }

    @Test
    public void loopOfHalfASecondIsALongTime() {
        assertEquals(List.of("1000000", "121000000", "121000010"), times(1_000_000, 500_000, 500_010));
    }

    @Test
    public void loopAtTheEndOfAPacketIsALongTime() {
        times(1_000_000);
        assertEquals(List.of("121000000"), times(500_000));
        assertEquals(List.of("121000010"), times(500_010));
    }

    @Test
    public void oneEventFarOutOfOrderDoesNotMoveTheOthers() {
        assertEquals(List.of("1000000", "500000", "1000010"), times(1_000_000, 500_000, 1_000_010));
    }

    @Test
    public void timeIsTakenAsItIsAfterAReset() {
        times(5_000_000);
        adapter.reset();
        assertEquals(List.of("3"), times(3));
    }

    @Test
    public void growsWithThePacket() {
        EventPacket<BasicEvent> packet = new EventPacket<>();
        for (int i = 0; i < 10_000; i++) {
            packet.events.add(Packets.event(i, i % 10, 0, Polarity.On));
        }
        List<String> events = read(packet);
        assertEquals(10_000, events.size());
        assertEquals("9999 9 7 1", events.get(9_999));
        assertSame(packet.events.get(9_999), read.event(9_999));
    }

    @Test
    public void keptEventsOutliveThePacket() {
        PolarityEvent event = Packets.event(5, 1, 2, Polarity.On);
        read(Packets.of(event));
        read.keepEvents();
        event.timestamp = 6;
        event.polarity = Polarity.Off;
        assertEquals(5, read.event(0).timestamp);
        assertEquals(1, read.event(0).x);
        assertEquals(2, read.event(0).y);
        assertEquals(Polarity.On, read.event(0).polarity);
    }

    @Test
    public void inertialSamplesAreAmongAllOfAPacket() {
        Iterator<? extends BasicEvent> all = PacketAdapter.all(Packets.mixed());
        int count = 0;
        while (all.hasNext()) {
            all.next();
            count++;
        }
        assertEquals(4, count);
    }
}
