package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A chip that the addresses cannot be of is refused by name, before anything is read. */
public class WrongChipTest {
    private static final int EVENTS = 20_000;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Events of noise all over a sensor, as AEDAT 2.0 without the line that names the chip. */
    private static byte[] unnamed(String chipName) throws IOException {
        Chip chip = Chip.named(chipName).orElseThrow();
        Random random = new Random(1);
        EventBatch batch = new EventBatch(EVENTS);
        for (int i = 0; i < EVENTS; i++) {
            batch.add(50L * i, random.nextInt(chip.sensor().width()), random.nextInt(chip.sensor().height()),
                random.nextBoolean() ? 1 : -1);
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (Aedat2Writer writer = new Aedat2Writer(bytes, chip)) {
            writer.write(batch);
        }
        String text = bytes.toString(StandardCharsets.ISO_8859_1);
        return text.replaceFirst("# AEChip: .*\r\n", "").getBytes(StandardCharsets.ISO_8859_1);
    }

    private ReadResult read(String name, byte[] bytes, RecordingOptions options) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), name, bytes, options);
    }

    private ReadResult read(byte[] bytes, String chip) throws IOException {
        return read("a.aedat", bytes, RecordingOptions.defaults().withChip(chip));
    }

    private void assertRefused(byte[] bytes, String chip, String why, String likely) throws IOException {
        ReadResult read = read(bytes, chip);
        assertEquals(0, read.events.size());
        assertTrue(chip + ": " + read.error, read.error != null && read.error.matches("\\[a\\.aedat\\] --chip " + chip
            + " must fit the addresses but of 20000 looked at " + why + "; " + likely + "; --force-chip takes them for "
            + "those of a " + chip));
    }

    @Test
    public void chipOfAnotherLayoutIsRefusedAndTheLikelyOneNamed() throws Exception {
        assertRefused(unnamed("DVS128"), "Davis346red", "(49|50) % are special events",
            "they look like those of a DVS128");
        assertRefused(unnamed("DAVIS240C"), "DVS128", "100 % have more than 16 bits",
            "they look like those of a DAVIS240C");
        assertRefused(unnamed("Davis346red"), "DAVIS240C", "\\d+ % of 20000 pixels lie outside 240x180",
            "they look like those of a Davis346red");
        assertRefused(unnamed("DAVIS240C"), "Davis346red", "all pixels lie within 240x180 and reach its corners",
            "they look like those of a DAVIS240C");
    }

    @Test
    public void rightChipIsTakenWithoutAWord() throws Exception {
        for (Chip chip : Chip.known()) {
            ReadResult read = read(unnamed(chip.name()), chip.name());
            assertNull(read.error, read.error);
            assertEquals(EVENTS, read.events.size());
        }
    }

    @Test
    public void forcedChipIsObeyedWhateverHeaderAndAddressesSay() throws Exception {
        RecordingOptions forced = RecordingOptions.defaults().withChip("Davis346red").withForceChip(true);
        ReadResult read = read("a.aedat", unnamed("DVS128"), forced);
        assertNull(read.error);
        assertTrue(read.events.size() + " events", read.events.size() > EVENTS / 3);
        byte[] named = new String(unnamed("DAVIS240C"), StandardCharsets.ISO_8859_1).replaceFirst("\r\n",
            "\r\n# AEChip: DAVIS240C\r\n").getBytes(StandardCharsets.ISO_8859_1);
        read = read("a.aedat", named, forced);
        // raw x runs from right to left, so that a wider sensor moves all to the right
        assertTrue(read.events.stream().allMatch(event -> Integer.parseInt(event.split(" ")[1]) >= 346 - 240));
    }

    @Test
    public void missingPolarityNamesTheChipThatHasBoth() throws Exception {
        // bit 0, the polarity of a DVS128, is not used by a DAVIS; 16 bits only, so that nothing else speaks against it
        byte[] bytes = unnamed("DVS128");
        ByteBuffer buffer = ByteBuffer.wrap(bytes);
        for (int at = bytes.length - 8 * EVENTS; at < bytes.length; at += 8) {
            buffer.putInt(at, buffer.getInt(at) & ~1);
        }
        // no chip has both polarities then: what was asked for is taken
        assertNull(read(bytes, "DVS128").error);
    }

    @Test
    public void wordsOfImuSamplesOutOfOrderAreNoDavis() throws Exception {
        Random random = new Random(2);
        ByteBuffer buffer = ByteBuffer.allocate(8 * EVENTS);
        for (int i = 0; i < EVENTS; i++) {
            buffer.putInt(random.nextInt() | 0x80000C00).putInt(i);
        }
        byte[] header = "#!AER-DAT2.0\r\n#End Of ASCII Header\r\n".getBytes(StandardCharsets.US_ASCII);
        byte[] bytes = ByteBuffer.allocate(header.length + buffer.capacity()).put(header).put(buffer.array()).array();
        assertRefused(bytes, "DAVIS240C", "8\\d % of 20000 words of IMU samples are not in their order",
            "no chip that is known fits");
    }

    @Test
    public void fileThatIsNoAedat1IsRefused() throws Exception {
        byte[] random = new byte[100_000];
        new Random(1).nextBytes(random);
        byte[] text = "0.003811 96 133 0\n".repeat(5000).getBytes(StandardCharsets.US_ASCII);
        byte[] other = unnamed("DVS128");
        for (byte[] bytes : new byte[][] {random, text, other}) {
            byte[] data = bytes == other ? java.util.Arrays.copyOfRange(other, other.length - 8 * EVENTS, other.length)
                : bytes;
            ReadResult read = read("a.dat", data, RecordingOptions.defaults().withChip("DVS128"));
            assertEquals(0, read.events.size());
            assertTrue(read.error, read.error.matches("\\[a\\.dat\\] header at byte 0: unsupported, the times of an "
                + "AEDAT 1.0 recording must not fall but \\d+ % of \\d+ looked at do: this is another format; "
                + "--force-chip takes it for AEDAT 1.0"));
        }
        ReadResult zeros = read("a.dat", new byte[6 * 1000], RecordingOptions.defaults().withChip("DVS128"));
        assertEquals("[a.dat] --chip DVS128 must fit the addresses but of 1000 looked at all are of one pixel; no chip "
            + "that is known fits; --force-chip takes them for those of a DVS128", zeros.error);
    }

    @Test
    public void pixelsOutsideTheSensorThatWasNamedAreRefusedInEveryFormat() throws Exception {
        StringBuilder text = new StringBuilder();
        Random random = new Random(4);
        for (int i = 0; i < EVENTS; i++) {
            text.append("0.").append(String.format("%06d", 40 * i)).append(' ').append(random.nextInt(240)).append(' ')
                .append(random.nextInt(180)).append(" 1\n");
        }
        byte[] bytes = text.toString().getBytes(StandardCharsets.US_ASCII);
        ReadResult read = read("a.txt", bytes, RecordingOptions.defaults().withChip("128x128"));
        assertTrue(read.error, read.error.matches("\\[a\\.txt\\] malformed, --chip 128x128 must fit the events but of "
            + "the first 20000, \\d+ lie outside 128x128, at x up to 239 and y up to 179, as of a DAVIS240A; "
            + "--force-chip takes what lies within"));
        assertEquals(0, read.events.size());
        read = read("a.txt", bytes, RecordingOptions.defaults().withChip("128x128").withForceChip(true));
        assertNull(read.error);
        assertEquals(EVENTS, read.events.size() + read.counts.outsideSensor());
    }
}
