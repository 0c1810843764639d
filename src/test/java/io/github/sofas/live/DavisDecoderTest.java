package io.github.sofas.live;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

/** Words by hand: a time is 0x8000 + µs, a row 0x1000 + y, an OFF event 0x2000 + x, an ON event 0x3000 + x. */
public class DavisDecoderTest {
    private static final SensorSize SENSOR = new SensorSize(240, 180);

    private final DavisDecoder decoder = new DavisDecoder(SENSOR, false);
    private final List<String> events = new ArrayList<>();

    private static byte[] bytes(int... words) {
        byte[] bytes = new byte[2 * words.length];
        for (int i = 0; i < words.length; i++) {
            bytes[2 * i] = (byte) words[i];
            bytes[2 * i + 1] = (byte) (words[i] >> 8);
        }
        return bytes;
    }

    private void decode(DavisDecoder with, byte[] data, int length) {
        EventBatch batch = new EventBatch(Math.max(1, with.mostEvents(length)));
        with.decode(data, length, batch);
        for (int i = 0; i < batch.size(); i++) {
            events.add(batch.timeUs[i] + " " + batch.x[i] + " " + batch.y[i] + " " + batch.polarity[i]);
        }
    }

    private void decode(int... words) {
        decode(decoder, bytes(words), 2 * words.length);
    }

    private long count(String name) {
        return decoder.counts().get(name);
    }

    @Test
    public void givesEveryColumnTheRowAndTimeBeforeIt() {
        decode(0x8005, 0x1007, 0x2003, 0x30EF, 0x8009, 0x3000, 0x10B3, 0x2001);
        assertEquals(List.of("5 3 7 -1", "5 239 7 1", "9 0 7 1", "9 1 179 -1"), events);
    }

    @Test
    public void goesOnInTheNextTransfer() {
        decode(0x8005, 0x1007);
        decode(0x2003);
        assertEquals(List.of("5 3 7 -1"), events);
    }

    @Test
    public void swapsRowsAndColumnsWhereTheCameraIsTurned() {
        // 180 columns and 240 rows on the wire.
        DavisDecoder swapped = new DavisDecoder(SENSOR, true);
        decode(swapped, bytes(0x8001, 0x10EF, 0x30B3, 0x30B4), 8);
        assertEquals(List.of("1 239 179 1"), events);
        assertEquals(1, (long) swapped.dropped().get("outside_sensor"));
    }

    @Test
    public void addsWhatEachWrapIsWorth() {
        // 0x7FFF = 32767 µs; one wrap: 32768 µs; three more: 131072 µs
        decode(0xFFFF, 0x1000, 0x2000, 0x7001, 0x8002, 0x2001, 0x7003, 0x2002, 0x8001, 0x2003);
        assertEquals(List.of("32767 0 0 -1", "32770 1 0 -1", "131072 2 0 -1", "131073 3 0 -1"), events);
        assertEquals(4, count("time_wraps"));
    }

    @Test
    public void countsTimeIn64Bits() {
        // 4095 wraps of 32.768 ms a word; 40 words are 5,367,398,400 µs, more than 32 bits hold.
        int[] words = new int[42];
        Arrays.fill(words, 0x7FFF);
        words[40] = 0x1000;
        words[41] = 0x2000;
        decode(words);
        assertEquals(List.of(40L * 4095 * 32768 + " 0 0 -1"), events);
    }

    @Test
    public void goesOnFromTheNewestTimeAfterAReset() {
        decode(0x8064, 0x1000, 0x2000, 0x0001, 0x8003, 0x2001, 0x7001, 0x2002);
        // 100; reset; 100 + 3; 100 + 32768
        assertEquals(List.of("100 0 0 -1", "103 1 0 -1", "32868 2 0 -1"), events);
        assertEquals(1, count("time_resets"));
        assertEquals(0, count("steps_back_in_time"));
    }

    @Test
    public void takesTheNewestTimeWhereTimeStepsBack() {
        decode(0x8064, 0x1000, 0x2000, 0x8032, 0x2001, 0x8065, 0x2002);
        assertEquals(List.of("100 0 0 -1", "100 1 0 -1", "101 2 0 -1"), events);
        assertEquals(1, count("steps_back_in_time"));
    }

    @Test
    public void findsTheWrapThatWasInALostTransfer() {
        decode(0xFFF0, 0x1000, 0x2000);
        decoder.lose();
        decode(0x8010, 0x1000, 0x2001);
        // 0x7FF0 = 32752; then 32768 + 16
        assertEquals(List.of("32752 0 0 -1", "32784 1 0 -1"), events);
        assertEquals(0, count("steps_back_in_time"));
        decode(0x8001, 0x2002);
        assertEquals("only the first time after a loss", 1, count("steps_back_in_time"));
    }

    @Test
    public void dropsColumnsWhoseRowWasLost() {
        decode(0x8001, 0x1000, 0x2000);
        decoder.lose();
        decode(0x2001, 0x3002, 0x1001, 0x2003);
        assertEquals(List.of("1 0 0 -1", "1 3 1 -1"), events);
        assertEquals(2, (long) decoder.dropped().get("without_row"));
    }

    @Test
    public void dropsAndCountsAddressesOutside() {
        // column 240; row 180 with two columns, one of which would be inside
        decode(0x8001, 0x1000, 0x20F0, 0x10B4, 0x2000, 0x20F0, 0x1001, 0x2000);
        assertEquals(List.of("1 0 1 -1"), events);
        assertEquals(3, (long) decoder.dropped().get("outside_sensor"));
        assertEquals(0, (long) decoder.dropped().get("without_row"));
    }

    @Test
    public void countsEveryOtherCode() {
        decode(0x0000, 0x0002, 0x0003, 0x0004, 0x0005, 0x5012, 0x5034, 0x0007, 0x0008, 0x000F, 0x4123, 0x4FFF, 0x6001,
            0x0FFF);
        assertEquals(List.of(), events);
        assertEquals("external input", 3, count("triggers"));
        assertEquals(1, count("imu_samples"));
        assertEquals(2, count("aps_samples"));
        // 0, IMU start, two IMU bytes, two frame marks, exposure, an unknown special
        assertEquals(8, count("other_words"));
    }

    @Test
    public void dropsAnOddLastByte() {
        decode(decoder, bytes(0x8001, 0x1002, 0x2003, 0x2004), 7);
        assertEquals(List.of("1 3 2 -1"), events);
        assertEquals(1, count("odd_bytes"));
        decode(decoder, new byte[1], 1);
        decode(decoder, new byte[0], 0);
        assertEquals(2, count("odd_bytes"));
    }
}
