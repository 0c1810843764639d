package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Opens recordings of every supported format. The first bytes of a file decide its format, then its extension. Where
 * the caller names the sensor, the events are checked against it unless the choice is forced.
 */
public final class Recordings {
    private static final byte[] AEDAT_MAGIC = "#!AER-DAT".getBytes(StandardCharsets.US_ASCII);
    private static final int VERSION_BYTES = 16;
    private static final int SHORTEST_VERSION_BYTES = 3;

    /** Number of events that are read to check whether they lie on the sensor. */
    private static final int PROBED = 1 << 16;
    private static final int PROBED_BATCH = 4096;

    /** Sizes of sensors that recordings without a header come from, smallest first. */
    private static final List<SensorSize> USUAL = List.of(new SensorSize(34, 34), new SensorSize(128, 128),
            new SensorSize(240, 180), new SensorSize(304, 240), new SensorSize(320, 240), new SensorSize(346, 260),
            new SensorSize(640, 480), new SensorSize(1280, 720));

    private Recordings() {
    }

    /**
     * Opens a recording. The magic at its start decides its format; where there is none, the file's extension does
     * ({@code .dat} and {@code .aedat} are AEDAT 1.0, {@code .bin} is N-MNIST, {@code .txt} and {@code .csv} are text).
     *
     * @param path the recording
     * @param options how it is read
     * @return a reader before the first event, to be closed by the caller
     * @throws MalformedRecordingException where the header is damaged or the format is not supported
     * @throws EventSourceException where the file cannot be read, or neither the recording nor the options name the
     *     sensor; the message then lists the known sensors
     */
    public static RecordingReader open(Path path, RecordingOptions options) throws EventSourceException {
        String failed = "[" + Printable.of(path.toString()) + "] cannot be opened: ";
        RecordingFile file = null;
        RecordingReader reader = null;
        try {
            if (Files.isDirectory(path)) {
                throw new EventSourceException(failed + "is a directory");
            }
            file = new RecordingFile(path);
            RecordingReader opened = readerFor(file, options);
            if (opened.isChipAsked() && !options.forceChip() && file.isSeekable()) {
                checkPixels(path, options);
            }
            reader = opened;
            return reader;
        } catch (SensorNotNamedException e) {
            throw e.takesSize() && file.isSeekable() ? e.with("; all its events lie within "
                    + smallestSensor(path, options)) : e;
        } catch (NoSuchFileException e) {
            throw new EventSourceException(failed + "no such file", e);
        } catch (AccessDeniedException e) {
            throw new EventSourceException(failed + "no permission to read it", e);
        } catch (IOException e) {
            String reason = e instanceof FileSystemException ? ((FileSystemException) e).getReason() : null;
            throw new EventSourceException(failed + Printable.of(reason == null ? e.toString() : reason), e);
        } finally {
            if (file != null && reader == null) {
                closeQuietly(file);
            }
        }
    }

    /**
     * Reads the first events to check whether they lie on the sensor that the caller named. Other faults are left to
     * the actual reading.
     */
    private static void checkPixels(Path path, RecordingOptions options) throws IOException, EventSourceException {
        try (RecordingFile file = new RecordingFile(path); RecordingReader reader = readerFor(file, options)) {
            EventBatch batch = new EventBatch(PROBED_BATCH);
            try {
                while (reader.counts().events() + reader.counts().outsideSensor() < PROBED && reader.next(batch)) {
                    // the reader counts
                    batch.clear();
                }
            } catch (EventSourceException e) {
                // the actual reading meets the fault again
                batch.clear();
            }
            reader.checkPixels(options.chip());
        }
    }

    private static RecordingReader readerFor(RecordingFile file, RecordingOptions options)
            throws IOException, EventSourceException {
        String version = aedatVersion(file);
        if (version == null) {
            return withoutAedatMagic(file, options);
        }
        switch (version) {
            case "1.0":
                return aedat2(file, options, "AEDAT 1.0", Aedat2Format.RECORD_BYTES_1);
            case "2.0":
                return aedat2(file, options, "AEDAT 2.0", Aedat2Format.RECORD_BYTES_2);
            case "3.0":
            case "3.1":
                return aedat3(file, options, version);
            case "4.0":
                return aedat4(file, options);
            default:
                throw new MalformedRecordingException("[" + file.name + "] header at byte 9: unsupported, the AEDAT "
                        + "version must be one of 1.0, 2.0, 3.0, 3.1, 4.0 but was \"" + version + "\"");
        }
    }

    private static RecordingReader withoutAedatMagic(RecordingFile file, RecordingOptions options)
            throws IOException, EventSourceException {
        if (startsWith(file, EventStreamReader.MAGIC)) {
            return EventStreamReader.open(file, options);
        }
        if (startsWith(file, Hdf5Reader.MAGIC)) {
            return Hdf5Reader.open(file, options);
        }
        if (PropheseeHeader.startsAt(file)) {
            return prophesee(file, options);
        }
        ForeignFormat foreign = ForeignFormat.at(file.buffer, file.position, file.limit);
        if (foreign != null) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: unsupported, it is "
                    + foreign.name() + "; " + foreign.remedy());
        }
        String lower = file.name.toLowerCase(Locale.ROOT);
        if (lower.endsWith(".dat") || lower.endsWith(".aedat")) {
            return aedat2(file, options, "AEDAT 1.0", Aedat2Format.RECORD_BYTES_1);
        }
        if (lower.endsWith(NMnistReader.EXTENSION)) {
            return named(file, options, NMnistReader::new);
        }
        if (lower.endsWith(".txt") || lower.endsWith(".csv")) {
            return named(file, options, TextReader::open);
        }
        boolean isCut = file.available() < EventStreamReader.MAGIC.length;
        throw new MalformedRecordingException("[" + file.name + "] header at byte 0: "
                + (isCut ? "truncated" : "unsupported") + ", a recording must begin as a known format does or have the "
                + "extension .aedat, .dat, .bin, .csv or .txt"
                + (isCut ? " but ended after " + file.available() + " bytes" : ""));
    }

    /** Opens a format that does not state its sensor. */
    @FunctionalInterface
    private interface Unnamed {
        RecordingReader open(RecordingFile file, RecordingOptions options, ChipChoice choice)
                throws IOException, EventSourceException;
    }

    private static RecordingReader named(RecordingFile file, RecordingOptions options, Unnamed format)
            throws IOException, EventSourceException {
        ChipChoice choice = ChipChoice.withSize(file.name, null, options);
        RecordingReader reader = format.open(file, options, choice);
        choice.reportTo(reader);
        return reader;
    }

    /** Opens RAW or DAT. Both have the same kind of header, but each states something that the other never does. */
    private static RecordingReader prophesee(RecordingFile file, RecordingOptions options)
            throws IOException, EventSourceException {
        PropheseeHeader header = PropheseeHeader.read(file);
        ChipChoice choice = ChipChoice.withOwnSize(file.name, 0, null, header.width(), header.height(),
                options);
        String encoding = header.encoding();
        boolean isDat = encoding == null && (header.hasOneOf("version", "data")
                || file.name.toLowerCase(Locale.ROOT).endsWith(".dat"));
        RecordingReader reader = isDat ? DatReader.open(file, options, header, choice)
                : evt(file, options, header, encoding, choice);
        choice.reportTo(reader);
        return reader;
    }

    private static RecordingReader evt(RecordingFile file, RecordingOptions options, PropheseeHeader header,
                                       String encoding, ChipChoice choice) throws MalformedRecordingException {
        switch (String.valueOf(encoding)) {
            case "EVT2":
                return new Evt2Reader(file, options, choice);
            case "EVT21":
                return new Evt21Reader(file, options, header.isLegacyEvt21(), choice);
            case "EVT3":
                return new Evt3Reader(file, options, choice);
            default:
                throw new MalformedRecordingException("[" + file.name + "] header at byte 0: unsupported, the encoding "
                        + "must be one of EVT2, EVT21, EVT3 but " + (encoding == null ? "the header does not say it"
                        : "was " + Printable.shortened(encoding)));
        }
    }

    private static boolean startsWith(RecordingFile file, byte[] magic) throws IOException {
        return file.require(magic.length) && Arrays.equals(file.buffer, file.position, file.position + magic.length,
                magic, 0, magic.length);
    }

    private static RecordingReader aedat2(RecordingFile file, RecordingOptions options, String formatName,
                                          int recordBytes) throws IOException, EventSourceException {
        AedatHeader header = AedatHeader.read(file);
        ChipChoice choice = ChipChoice.withLayout(file.name, header.chip(), options);
        if (recordBytes == Aedat2Format.RECORD_BYTES_1 && choice.chip().layout() != Chip.AddressLayout.DVS128) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: unsupported, the chip of an "
                    + "AEDAT 1.0 recording must have 16-bit addresses but was " + choice.name());
        }
        if (choice.asked() && !options.forceChip() && file.isSeekable()) {
            AddressCheck.check(file, recordBytes, choice.chip());
        }
        RecordingReader reader = new Aedat2Reader(file, options, formatName, recordBytes, choice.name(), choice.chip());
        choice.reportTo(reader);
        return reader;
    }

    private static RecordingReader aedat3(RecordingFile file, RecordingOptions options, String version)
            throws IOException, EventSourceException {
        AedatHeader header = AedatHeader.read(file);
        if (!header.hasEndLine()) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte " + file.offset() + ": "
                    + (file.available() == 0 ? "truncated" : "malformed") + ", it must end with the line #!END-HEADER");
        }
        if (header.encoding() != null && !header.encoding().equalsIgnoreCase(Aedat3Format.RAW)) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: unsupported, the format must "
                    + "be " + Aedat3Format.RAW + " but was " + header.encoding());
        }
        ChipChoice choice = ChipChoice.withSize(file.name, header.chip(), options);
        RecordingReader reader = new Aedat3Reader(file, options, version, header.source(), choice);
        choice.reportTo(reader);
        return reader;
    }

    private static RecordingReader aedat4(RecordingFile file, RecordingOptions options)
            throws IOException, EventSourceException {
        Aedat4Header header = Aedat4Header.read(file);
        for (Map.Entry<Integer, Aedat4Header.Stream> entry : header.streams().entrySet()) {
            Aedat4Header.Stream stream = entry.getValue();
            if (Aedat4Format.EVENTS.equals(stream.type())) {
                ChipChoice choice = ChipChoice.withOwnSize(file.name, Aedat4Format.MAGIC_BYTES, stream.chip(),
                        stream.width(), stream.height(), options);
                RecordingReader reader = new Aedat4Reader(file, options, header, entry.getKey(), choice);
                choice.reportTo(reader);
                return reader;
            }
        }
        throw new MalformedRecordingException("[" + file.name + "] header at byte " + Aedat4Format.MAGIC_BYTES
                + ": unsupported, a recording must declare a stream of events (EVTS) but had " + header.streams().size()
                + " others");
    }

    /**
     * {@return the smallest usual sensor that holds all events of a recording} This is a guess for recordings that name
     * none.
     *
     * @param path the recording
     * @param options how the recording is read; the chip in the options is not used
     * @throws EventSourceException where the recording cannot be opened
     */
    public static SensorSize smallestSensor(Path path, RecordingOptions options) throws EventSourceException {
        RecordingOptions largest = options.withChip(USUAL.get(USUAL.size() - 1).toString()).withForceChip(true);
        int greatestX = 0;
        int greatestY = 0;
        try (RecordingReader reader = open(path, largest)) {
            EventBatch batch = new EventBatch(PROBED_BATCH);
            try {
                while (reader.next(batch)) {
                    for (int i = 0; i < batch.size(); i++) {
                        greatestX = Math.max(greatestX, batch.x[i]);
                        greatestY = Math.max(greatestY, batch.y[i]);
                    }
                }
            } catch (EventSourceException e) {
                // the actual reading meets the fault again
                batch.clear();
            }
        }
        int x = greatestX;
        int y = greatestY;
        return USUAL.stream().filter(sensor -> sensor.contains(x, y)).findFirst().orElseThrow();
    }

    /**
     * {@return whether the first lines of a text file read as events} This distinguishes recordings from other texts in
     * a folder.
     *
     * @param path the recording
     */
    public static boolean isText(Path path) {
        try (RecordingFile file = new RecordingFile(path)) {
            return TextLayout.fits(file);
        } catch (IOException e) {
            return false;
        }
    }

    /** The version that follows the magic on the first line; null where the file does not start with the magic. */
    private static String aedatVersion(RecordingFile file) throws IOException, MalformedRecordingException {
        file.require(AEDAT_MAGIC.length + VERSION_BYTES);
        if (file.available() == 0) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: truncated, a recording must "
                    + "not be empty");
        }
        int same = Arrays.mismatch(file.buffer, 0, file.available(), AEDAT_MAGIC, 0, AEDAT_MAGIC.length);
        if (same >= 0 && same < Math.min(file.available(), AEDAT_MAGIC.length)) {
            return null;
        }
        if (file.available() < AEDAT_MAGIC.length + SHORTEST_VERSION_BYTES) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: truncated, the first line "
                    + "must have a version but ended after " + file.available() + " bytes");
        }
        int end = AEDAT_MAGIC.length;
        while (end < Math.min(file.available(), AEDAT_MAGIC.length + VERSION_BYTES) && file.buffer[end] > ' ') {
            end++;
        }
        return Printable.of(new String(file.buffer, AEDAT_MAGIC.length, end - AEDAT_MAGIC.length,
                StandardCharsets.US_ASCII));
    }

    private static void closeQuietly(RecordingFile file) {
        try {
            file.close();
        } catch (IOException e) {
            // The failure that led here is the one to report.
            return;
        }
    }
}
