package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.GreyFrame;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import org.junit.Before;
import org.junit.Test;

/** Recordings of real cameras, which the project may not hold itself. */
public class RealRecordingsTest {
    private static final Path FOLDER = Path.of("..", "shared", "recordings");

    /** Checksums of the same events as faery reads them. */
    private static final long SPOT = 0xd37a36f6L;
    private static final long SPARKS = 0xfae28235L;
    private static final long AEROPLANE = 0xde3619adL;

    /** What was read: counts, and a checksum over the events with time from the first event on. */
    private static final class Read {
        final RecordingCounts counts;
        final List<String> faults;
        final long firstTimeUs;
        final long lastTimeUs;
        final long checksum;

        Read(RecordingReader reader, long checksum) {
            counts = reader.counts();
            faults = reader.faults();
            firstTimeUs = reader.firstTimeUs();
            lastTimeUs = reader.lastTimeUs();
            this.checksum = checksum;
        }
    }

    @Before public void needsTheFolder() {
        if (!Files.isDirectory(FOLDER)) {
            throw Skipped.because("needs " + FOLDER + ", which is not part of the project");
        }
    }

    @Test public void countsTheEventsOfEveryRecording() throws Exception {
        assertFaultless(16_000, "synthetic-square.aedat", "DAVIS240C");
        assertFaultless(10_000, "synthetic-bar-x.aedat", "DAVIS240C");
        assertFaultless(100_000, "synthetic-double-bar.aedat", "DAVIS240C");
        assertFaultless(340_394, "stripes.aedat", null);
        assertFaultless(115_839, "building.aedat", null);
        assertFaultless(50_000, "slider-depth.aedat", null);
        assertFaultless(489_834, "dark-box.aedat", "DVS128");
        assertFaultless(278_538, "pendulum-ball.aedat", null);
        assertFaultless(293_096, "mouse-negative-time.aedat", null);
        assertFaultless(290_292, "standing-up.aedat", null);
        assertFaultless(70_304, "walking.aedat", null);
        assertFaultless(6_676, "cars-first-170ms.aedat4", null);
        assertFaultless(323_963, "moving-head.aedat4", null);
    }

    @Test public void readsOneSceneAlikeFromFiveFormats() throws Exception {
        Read lz4 = assertFaultless(78_830, "cars.aedat4", null);
        Read zstd = assertFaultless(78_830, "cars-zstd.aedat4", null);
        Read aedat2 = assertFaultless(78_830, "cars.aedat", null);
        assertEquals(lz4.checksum, zstd.checksum);
        assertEquals(lz4.checksum, aedat2.checksum);
        for (String hdf5 : List.of("cars-dsec.h5", "cars-mvsec.h5")) {
            Read read = assertFaultless(78_830, hdf5, "346x260");
            assertEquals(lz4.checksum, read.checksum);
            assertEquals(lz4.firstTimeUs, read.firstTimeUs);
        }
        assertEquals(59, lz4.counts.frames());
        assertEquals(2_363, lz4.counts.imuSamples());
        assertEquals(236, lz4.counts.triggers());
    }

    @Test public void readsOneSliceAlikeFromAedat1And2And3() throws Exception {
        Read aedat1 = assertFaultless(123_702, "dark-box-8s.aedat1.dat", "DVS128");
        Read aedat2 = assertFaultless(123_702, "dark-box-8s.aedat2.aedat", null);
        Read aedat3 = assertFaultless(123_702, "dark-box-8s.aedat3.aedat", null);
        assertEquals(aedat2.checksum, aedat1.checksum);
        assertEquals(aedat2.checksum, aedat3.checksum);
        assertEquals(aedat2.lastTimeUs, aedat1.lastTimeUs);
        assertEquals(aedat2.lastTimeUs, aedat3.lastTimeUs);
    }

    @Test public void readsTextAndAedat2Alike() throws Exception {
        Read aedat2 = assertFaultless(50_000, "slider-depth.aedat", null);
        Read text = assertFaultless(50_000, "slider-depth.txt", "240x180");
        assertEquals(aedat2.checksum, text.checksum);
        assertEquals(aedat2.firstTimeUs, text.firstTimeUs);
    }

    /** Counts and checksums are those of faery's decoders (PyPI, 0.7.1). */
    @Test public void readsPropheseesFormatsAndEventStreamAsFaeryDoes() throws Exception {
        Read evt3 = assertFaultless(1_218_618, "spot-evt3.raw", null);
        Read dat = assertFaultless(1_218_618, "spot.dat", null);
        assertEquals(SPOT, evt3.checksum);
        assertEquals(SPOT, dat.checksum);
        assertEquals(11_200_224, evt3.firstTimeUs);
        assertEquals(5_856, dat.firstTimeUs);
        assertEquals(SPARKS, assertFaultless(521_252, "sparks-evt2.raw", "640x480").checksum);
        assertEquals(AEROPLANE, assertFaultless(473_225, "aeroplane.es", null).checksum);
    }

    @Test public void readsTheDigitsOfNMnist() throws Exception {
        assertFaultless(4_325, "nmnist.bin", "34x34");
        assertFaultless(4_681, "nmnist-1.bin", "34x34");
        assertFaultless(5_028, "nmnist-2.bin", "34x34");
    }

    @Test public void reportsTheImuSampleThatTheEndCutsOff() throws Exception {
        Read read = read("boxes-translation.aedat", null);
        assertEquals(162_771, read.counts.events());
        assertEquals(4_833, read.counts.imuSamples());
        assertEquals(List.of("[boxes-translation.aedat] event 162771 at byte 1748132: truncated, an IMU sample must "
                + "have 7 words but had 6"), read.faults);
    }

    @Test public void keepsNegativeTimes() throws Exception {
        Read read = read("mouse-negative-time.aedat", null);
        assertEquals(-1_293_810_339L, read.firstTimeUs);
        assertEquals(-1_275_385_039L, read.lastTimeUs);
        assertEquals(0, read.counts.timeWraps());
    }

    @Test public void deliversTheFramesOfADavis346() throws Exception {
        List<GreyFrame> frames = new ArrayList<>();
        EventBatch batch = new EventBatch(4096);
        try (RecordingReader reader = Recordings.open(FOLDER.resolve("cars.aedat4"), RecordingOptions.defaults())) {
            reader.onFrame(frames::add);
            while (reader.next(batch)) {
                assertTrue(reader.faults().isEmpty());
            }
            assertEquals(59, frames.size());
            for (GreyFrame frame : frames) {
                assertEquals(346, frame.width());
                assertTrue(Math.abs(frame.timeUs() - reader.firstTimeUs()) < 3_000_000);
            }
        }
    }

    private static Read assertFaultless(long events, String name, String chip) throws Exception {
        Read read = read(name, chip);
        assertEquals(name, events, read.counts.events());
        assertEquals(name, List.of(), read.faults);
        return read;
    }

    private static Read read(String name, String chip) throws Exception {
        CRC32 checksum = new CRC32();
        ByteBuffer event = ByteBuffer.allocate(13);
        EventBatch batch = new EventBatch(4096);
        RecordingOptions options = RecordingOptions.defaults().withChip(chip);
        try (RecordingReader reader = Recordings.open(FOLDER.resolve(name), options)) {
            while (reader.next(batch)) {
                for (int i = 0; i < batch.size(); i++) {
                    assertTrue(reader.sensor().contains(batch.x[i], batch.y[i]));
                    event.clear().putLong(batch.timeUs[i] - reader.firstTimeUs()).putShort(batch.x[i])
                            .putShort(batch.y[i]).put(batch.polarity[i]);
                    checksum.update(event.array());
                }
            }
            return new Read(reader, checksum.getValue());
        }
    }
}
