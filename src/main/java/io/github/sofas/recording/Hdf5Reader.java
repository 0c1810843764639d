package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.jhdf.HdfFile;
import io.jhdf.exceptions.HdfException;
import io.jhdf.exceptions.UnsupportedHdfException;
import io.jhdf.filter.FilterManager;
import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Reads HDF5 files with events ({@link Hdf5Layout}) by the library jHDF. Data may be plain or packed by deflate, LZF,
 * LZ4, Zstandard, Blosc ({@link BloscFilter}) or Prophesee's ECF ({@link EcfFilter}). Holds the chunks of one stretch
 * of events.
 */
final class Hdf5Reader extends RecordingReader {
    static final byte[] MAGIC = {(byte) 0x89, 'H', 'D', 'F', '\r', '\n', 0x1A, '\n'};

    private static final double US_PER_S = 1e6;
    /** Start of jHDF's message about a filter that it does not know. */
    private static final String NO_FILTER = "A required filter is not available:";

    static {
        FilterManager.addFilter(new BloscFilter());
        FilterManager.addFilter(new EcfFilter());
        FilterManager.addFilter(new ZstdFilter());
    }

    /** Place of the file's length in superblocks of version 0, 1, 2 and 3, for addresses of eight bytes. */
    private static final int[] END_AT = {40, 44, 28, 28};
    private static final int VERSION_AT = 8;

    private final HdfFile hdf;
    private final Hdf5Layout layout;
    /** The data sets that hold the events. */
    private final Set<Hdf5Rows> datasets;
    private final long count;
    private final int stretch;
    private final long[] columns;
    private final long[] rows;
    private final long[] polarities;
    private final long[] times;
    /** The next event to be decoded, and the end of the stretch of events that was read. */
    private long next;
    private long readTo;
    private int inStretch;

    private Hdf5Reader(RecordingFile file, RecordingOptions options, HdfFile hdf, Hdf5Layout layout,
                       ChipChoice choice) {
        super(file, options, "HDF5 (" + layout.name() + ")", choice.name(), choice.sensor());
        this.hdf = hdf;
        this.layout = layout;
        datasets = new LinkedHashSet<>();
        for (Hdf5Rows.Column column : List.of(layout.x(), layout.y(), layout.polarity(), layout.time())) {
            datasets.add(column.rows());
        }
        count = layout.x().rows().count();
        int longest = 1;
        for (Hdf5Rows dataset : datasets) {
            if (dataset.count() != count) {
                throw new HdfException("all data sets of the events must have one length but have " + count + " and "
                        + dataset.count());
            }
            longest = Math.max(longest, dataset.stretch());
        }
        stretch = (int) Math.max(1, Math.min(longest, count));
        columns = new long[stretch];
        rows = new long[stretch];
        polarities = new long[stretch];
        times = new long[stretch];
    }

    /** Finds the events and makes a reader at the first one. */
    static Hdf5Reader open(RecordingFile file, RecordingOptions options) throws EventSourceException {
        try {
            HdfFile hdf = file.asHdf5();
            Hdf5Layout layout = Hdf5Layout.of(hdf);
            ChipChoice choice = choice(file, options, layout);
            Hdf5Reader reader = new Hdf5Reader(file, options, hdf, layout, choice);
            choice.reportTo(reader);
            return reader;
        } catch (RuntimeException | StackOverflowError e) {
            throw new MalformedRecordingException("[" + file.name + "] header at byte 0: " + reason(file, e), e);
        }
    }

    private static ChipChoice choice(RecordingFile file, RecordingOptions options, Hdf5Layout layout)
            throws EventSourceException {
        try {
            return ChipChoice.withOwnSize(file.name, 0, null, layout.width(), layout.height(), options);
        } catch (SensorNotNamedException e) {
            throw layout.usualSensor() == null ? e : e.with("; " + layout.name() + "'s is " + layout.usualSensor());
        }
    }

    /**
     * Explains a failure of the library: by the missing end of a truncated file, by the library's own message, or by
     * the kind of exception where a damaged file led the library astray.
     */
    private static String reason(RecordingFile file, Throwable e) {
        String truncated = truncated(file);
        if (truncated != null) {
            return truncated;
        }
        String message = String.valueOf(e.getMessage());
        if (e instanceof UnsupportedHdfException) {
            return "unsupported, " + Printable.shortened(message);
        }
        if (message.startsWith(NO_FILTER)) {
            return "unsupported, packed by an unsupported filter (" + Printable.shortened(message.substring(
                    NO_FILTER.length()).strip()) + "); h5repack -f GZIP=5 packs it anew";
        }
        Throwable cause = e;
        while (cause.getCause() != null && cause.getCause() != cause) {
            cause = cause.getCause();
        }
        return "malformed, HDF5 must be whole: " + Printable.shortened(e instanceof HdfException
                ? message + (cause == e ? "" : ": " + cause.getMessage()) : cause.toString());
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (next == count) {
            checkEnd();
            return false;
        }
        if (next == readTo) {
            readStretch();
        }
        int n = 0;
        int width = sensor().width();
        int height = sensor().height();
        try {
            for (int i = inStretch - (int) (readTo - next); i < inStretch && n < batch.capacity(); i++, next++) {
                long column = columns[i];
                long row = rows[i];
                if (column < 0 || column >= width || row < 0 || row >= height) {
                    outside(clamped(column), clamped(row), eventNumber(n), next);
                    continue;
                }
                note(n, next);
                batch.timeUs[n] = times[i];
                batch.x[n] = (short) column;
                batch.y[n] = (short) row;
                batch.polarity[n] = (byte) (polarities[i] > 0 ? 1 : -1);
                n++;
            }
        } finally {
            deliver(batch, n);
        }
        return true;
    }

    /**
     * Checks that the file is complete. All events may be present although something else is missing, or although a
     * lost chunk was taken for one of zeros.
     */
    private void checkEnd() throws MalformedRecordingException {
        String truncated = truncated(file);
        if (truncated != null) {
            throw malformed(eventNumber(0), 0, truncated);
        }
    }

    /**
     * The fault of a file that is shorter than its superblock states; null where it is not, or where that cannot be
     * read.
     */
    private static String truncated(RecordingFile file) {
        try {
            file.seek(0);
            file.require(END_AT[1] + Long.BYTES);
            int version = file.available() > VERSION_AT ? file.buffer[file.position + VERSION_AT] : 0;
            if (version < 0 || version >= END_AT.length) {
                return null;
            }
            int header = END_AT[version] + Long.BYTES;
            if (file.available() < header) {
                return "truncated, the header must have " + header + " bytes but had " + file.available();
            }
            long bytes = (long) EvtFormat.LONG.get(file.buffer, file.position + END_AT[version]);
            return bytes <= file.size() ? null : "truncated, the file must have " + bytes + " bytes but had "
                + file.size();
        } catch (IOException e) {
            return null;
        }
    }

    private static int clamped(long coordinate) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, coordinate));
    }

    private void readStretch() throws IOException, MalformedRecordingException {
        inStretch = (int) Math.min(stretch, count - next);
        try {
            for (Hdf5Rows dataset : datasets) {
                dataset.read(next, inStretch);
            }
            layout.x().copyTo(columns, 0, inStretch);
            layout.y().copyTo(rows, 0, inStretch);
            layout.polarity().copyTo(polarities, 0, inStretch);
            if (layout.time().isReal()) {
                layout.time().copyScaledTo(times, 0, inStretch, US_PER_S);
            } else {
                layout.time().copyTo(times, 0, inStretch);
            }
        } catch (RuntimeException | StackOverflowError e) {
            throw new MalformedRecordingException(at(eventNumber(0), 0) + reason(file, e), e);
        }
        for (int i = 0; i < inStretch; i++) {
            times[i] += layout.timeOffsetUs();
        }
        readTo = next + inStretch;
        // for progress: the bytes of an event lie in several places
        file.seek((long) ((double) readTo / count * file.size()));
    }

    @Override
    void release() {
        try {
            hdf.close();
        } catch (HdfException e) {
            // Nothing was written, so a failure to close loses nothing.
            return;
        }
    }

    /** Names only the event, because it lies at as many places as it has columns. */
    @Override
    String at(long event, long place) {
        return "[" + file.name + "] event " + event + ": ";
    }
}
