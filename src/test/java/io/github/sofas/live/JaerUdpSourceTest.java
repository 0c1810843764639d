package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.Chip;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/** Datagrams on this machine's own address, one at a time, so that none is lost but by the test. */
public class JaerUdpSourceTest {
    private static final Chip DAVIS240C = Chip.named("DAVIS240C").orElseThrow();

    private final EventBatch batch = new EventBatch(8192);
    private JaerUdpSource source;
    private DatagramSocket sender;

    @Before
    public void open() throws Exception {
        source = new JaerUdpSource(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), DAVIS240C);
        sender = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    }

    @After
    public void close() {
        source.close();
        sender.close();
    }

    private void send(int... words) throws IOException {
        ByteBuffer data = ByteBuffer.allocate(4 * words.length);
        for (int word : words) {
            data.putInt(word);
        }
        sendBytes(data.array());
    }

    private void sendBytes(byte[] data) throws IOException {
        sender.send(new DatagramPacket(data, data.length, InetAddress.getLoopbackAddress(), source.port()));
    }

    /** Address of a DAVIS240C: raw x from the right in bits 12 to 21, raw y from the bottom in bits 22 to 30. */
    private static int on(int x, int y) {
        return 239 - x << 12 | 179 - y << 22 | 1 << 11;
    }

    private List<String> next() throws EventSourceException {
        assertTrue(source.next(batch));
        List<String> events = new ArrayList<>();
        for (int i = 0; i < batch.size(); i++) {
            events.add(batch.timeUs[i] + " " + batch.x[i] + " " + batch.y[i] + " " + batch.polarity[i]);
        }
        return events;
    }

    private long count(String name) {
        return source.counts().get(name);
    }

    @Test
    public void decodesAddressesAsJaerSendsThem() throws Exception {
        // 0x000EF000: raw (239, 0), OFF
        send(1, on(3, 4), 1000, 0x000EF000, 1001);
        assertEquals(List.of("1000 3 4 1", "1001 0 179 -1"), next());
        assertEquals("jAER AEUnicast", source.formatName());
    }

    @Test
    public void takesTheLargestDatagramThatJaerSends() throws Exception {
        int[] words = new int[1 + 2 * 7874];
        words[0] = 1;
        for (int i = 1; i < words.length; i += 2) {
            words[i] = on(i % 240, 0);
            words[i + 1] = i;
        }
        send(words);
        assertEquals(7874, next().size());
    }

    @Test
    public void countsDatagramsThatAreMissing() throws Exception {
        send(1, on(0, 0), 10);
        send(2, on(0, 0), 20);
        send(7, on(0, 0), 30);
        next();
        next();
        next();
        assertEquals(4, source.packetsLost());
        source.stop();
        assertEquals(List.of("[UDP port 0] 4 datagrams were lost"), source.faults());
    }

    @Test
    public void doesNotUseADatagramThatWasOvertaken() throws Exception {
        send(5, on(0, 0), 10);
        send(7, on(0, 0), 30);
        send(6, on(0, 0), 20);
        send(8, on(1, 0), 40);
        next();
        next();
        assertEquals(List.of("40 1 0 1"), next());
        source.stop();
        assertEquals(1, count("datagrams_overtaken"));
        assertEquals(1, count("datagrams_lost"));
    }

    @Test
    public void goesOnWithASenderThatStartedAgain() throws Exception {
        send(500, on(0, 0), 5_000_000);
        send(1, on(1, 0), 7);
        send(2, on(2, 0), 9);
        next();
        // its time was set to zero: on from the newest
        assertEquals(List.of("5000000 1 0 1"), next());
        assertEquals(List.of("5000002 2 0 1"), next());
        source.stop();
        assertEquals(1, count("sender_restarts"));
        assertEquals(1, count("time_resets"));
        assertEquals(0, count("datagrams_lost"));
    }

    @Test
    public void countsSequenceNumbersOverTheirEnd() throws Exception {
        send(Integer.MAX_VALUE, on(0, 0), 1);
        send(Integer.MIN_VALUE, on(0, 0), 2);
        send(Integer.MIN_VALUE + 1, on(0, 0), 3);
        next();
        next();
        next();
        source.stop();
        assertEquals(0, count("datagrams_lost"));
        assertEquals(0, count("sender_restarts"));
    }

    @Test
    public void undoesTheOverflowOfTime() throws Exception {
        send(1, on(0, 0), Integer.MAX_VALUE, on(1, 0), Integer.MIN_VALUE, on(2, 0), -1, on(3, 0), 0);
        assertEquals(List.of("2147483647 0 0 1", "2147483648 1 0 1", "4294967295 2 0 1", "4294967296 3 0 1"), next());
        source.stop();
        assertEquals(1, count("time_wraps"));
    }

    @Test
    public void takesTheNewestTimeWhereTimeStepsBackALittle() throws Exception {
        send(1, on(0, 0), 100, on(1, 0), 90, on(2, 0), 101);
        assertEquals(List.of("100 0 0 1", "100 1 0 1", "101 2 0 1"), next());
        source.stop();
        assertEquals(1, count("steps_back_in_time"));
    }

    @Test
    public void countsWhatIsNoEventOfTheSensor() throws Exception {
        // an intensity sample, a trigger, x = 240 on the wire, y = 180 on the wire
        send(1, 0x80000000, 5, 0x00000400, 5, 240 << 12, 5, 180 << 22, 5, on(0, 0), 6);
        assertEquals(List.of("6 0 0 1"), next());
        source.stop();
        assertEquals(2, count("other_records"));
        assertEquals(2, (long) source.dropped().get("outside_sensor"));
    }

    @Test
    public void countsBytesThatMakeNoEvent() throws Exception {
        sendBytes(new byte[3]);
        sendBytes(new byte[0]);
        send(1);
        send(2, on(0, 0), 6, 7);
        assertEquals(List.of("6 0 0 1"), next());
        source.stop();
        assertFalse(source.next(batch));
        assertEquals(7, count("odd_bytes"));
        assertEquals(4, count("datagrams"));
    }

    @Test
    public void saysThatThePortIsTaken() {
        InetSocketAddress taken = new InetSocketAddress(InetAddress.getLoopbackAddress(), source.port());
        EventSourceException refused = assertThrows(EventSourceException.class,
            () -> new JaerUdpSource(taken, DAVIS240C));
        String start = "[UDP port " + source.port() + "] cannot be listened to: ";
        assertEquals(start, refused.getMessage().substring(0, start.length()));
    }
}
