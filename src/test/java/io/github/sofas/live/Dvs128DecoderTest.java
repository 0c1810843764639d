package io.github.sofas.live;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.JaerAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Addresses by hand: bit 0 set for OFF, x from the right in bits 1 to 7, y from the bottom in bits 8 to 14. */
public class Dvs128DecoderTest {
    private final Dvs128Decoder decoder = new Dvs128Decoder(new JaerAddress(Chip.named("DVS128").orElseThrow()));
    private final List<String> events = new ArrayList<>();

    /** Addresses and times in turn. */
    private void decode(int spareBytes, int... words) {
        byte[] data = new byte[2 * words.length + spareBytes];
        for (int i = 0; i < words.length; i++) {
            data[2 * i] = (byte) words[i];
            data[2 * i + 1] = (byte) (words[i] >> 8);
        }
        EventBatch batch = new EventBatch(Math.max(1, decoder.mostEvents(data.length)));
        decoder.decode(data, data.length, batch);
        for (int i = 0; i < batch.size(); i++) {
            events.add(batch.timeUs[i] + " " + batch.x[i] + " " + batch.y[i] + " " + batch.polarity[i]);
        }
    }

    @Test
    public void turnsAddressesToTheUpperLeftCorner() {
        // raw (0, 0) ON is (127, 127); raw (127, 127) OFF is (0, 0); raw x 1, raw y 2 is (126, 125)
        decode(0, 0x0000, 10, 0x7FFF, 11, 0x0202, 11);
        assertEquals(List.of("10 127 127 1", "11 0 0 -1", "11 126 125 1"), events);
    }

    @Test
    public void addsWrapsAndGoesOnAfterAReset() {
        // wrap: 16384; reset: zero is now at 16386
        decode(0, 0, 16_383, 0x1234, 0x8000, 0, 2, 0x4321, 0x4000, 0, 5);
        assertEquals(List.of("16383 127 127 1", "16386 127 127 1", "16391 127 127 1"), events);
        assertEquals(1, (long) decoder.counts().get("time_wraps"));
        assertEquals(1, (long) decoder.counts().get("time_resets"));
    }

    @Test
    public void findsTheWrapThatWasInALostTransfer() {
        decode(0, 0, 16_000);
        decoder.lose();
        decode(0, 0, 100);
        assertEquals(List.of("16000 127 127 1", "16484 127 127 1"), events);
    }

    @Test
    public void countsSynchronisationEventsAndOddBytes() {
        decode(3, 0x8000, 7, 0, 8);
        assertEquals(List.of("8 127 127 1"), events);
        assertEquals(1, (long) decoder.counts().get("triggers"));
        assertEquals(3, (long) decoder.counts().get("odd_bytes"));
    }
}
