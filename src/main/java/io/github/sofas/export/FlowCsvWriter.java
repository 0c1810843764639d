package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Writes one row for every event: {@value #HEADER}.
 *
 * <p>Velocities have three decimals with a point in every locale. They are rounded half away from zero, from the exact
 * value of the float. If an event has no flow, the two fields are empty and the segment is 0. Lines end in LF. The same
 * events and flow give the same bytes.
 */
public final class FlowCsvWriter implements FlowWriter {
    /** The first line, without its line end. */
    public static final String HEADER = EventCsvReader.EVENT_COLUMNS + FlowCsvWriter.ID_COLUMN;
    static final String ID_COLUMN = "segment";

    /**
     * Room per row; no row is longer: time 20, x and y 6 each, polarity 4, velocities 17 each, segment 11, seven
     * separators.
     */
    private static final int ROW_LIMIT = 96;
    private static final byte[] NO_FLOW = {',', ',', '0', '\n'};
    /**
     * Number of segments whose last velocity is kept as text: a power of two; most recordings have fewer segments at
     * once.
     */
    private static final int TEXTS = 64;
    private static final int TEXT_LIMIT = 64;

    private final OutputStream out;
    private final CsvBuffer buffer;

    // All events of one millisecond share the text of their time, except for its last three digits.
    private long millisecondUs;
    private final byte[] millisecondText = new byte[24];
    private int millisecondLength;

    // All events of a segment have one velocity until it is measured again, so its text is made once.
    private final int[] textSegment = new int[TEXTS];
    private final float[] textVx = new float[TEXTS];
    private final float[] textVy = new float[TEXTS];
    private final byte[] texts = new byte[TEXTS * TEXT_LIMIT];
    private final int[] textLength = new int[TEXTS];

    /**
     * Writes the header.
     *
     * @param out receives the rows; closed by {@link #close()}; needs no buffer
     * @throws IOException if the header cannot be written
     */
    public FlowCsvWriter(OutputStream out) throws IOException {
        this.out = out;
        this.buffer = new CsvBuffer(out);
        buffer.put(HEADER);
        buffer.put('\n');
    }

    /**
     * Writes the rows of a batch.
     *
     * @param batch the events
     * @param flow labels of the same events
     * @throws IOException if the rows cannot be written
     */
    @Override
    public void write(EventBatch batch, FlowOutput flow) throws IOException {
        int size = batch.size();
        for (int i = 0; i < size; i++) {
            buffer.makeRoom(ROW_LIMIT);
            putTime(batch.timeUs[i]);
            buffer.putWithComma(batch.x[i]);
            buffer.putWithComma(batch.y[i]);
            if (batch.polarity[i] < 0) {
                buffer.put('-');
            }
            buffer.put('1');
            buffer.put(',');
            int segment = flow.segment[i];
            if (segment == 0) {
                buffer.put(NO_FLOW, 0, NO_FLOW.length);
            } else {
                putFlow(segment, flow.vxPxPerS[i], flow.vyPxPerS[i]);
            }
        }
    }

    private void putTime(long timeUs) {
        // Below a millisecond, and before zero, the last three digits are not a suffix: the time is written whole.
        if (timeUs < 1000) {
            buffer.put(timeUs);
            buffer.put(',');
            return;
        }
        long rest = timeUs - millisecondUs;
        if (rest < 0 || rest >= 1000) {
            int start = buffer.size;
            buffer.put(timeUs / 1000);
            millisecondLength = buffer.size - start;
            System.arraycopy(buffer.bytes, start, millisecondText, 0, millisecondLength);
            buffer.size = start;
            millisecondUs = timeUs - timeUs % 1000;
            rest = timeUs - millisecondUs;
        }
        buffer.put(millisecondText, 0, millisecondLength);
        buffer.putThreeDigitsWithComma((int) rest);
    }

    private void putFlow(int segment, float vxPxPerS, float vyPxPerS) {
        int slot = segment & TEXTS - 1;
        int from = slot * TEXT_LIMIT;
        if (textSegment[slot] != segment || textVx[slot] != vxPxPerS || textVy[slot] != vyPxPerS) {
            int start = buffer.size;
            buffer.putVelocity(vxPxPerS);
            buffer.put(',');
            buffer.putVelocity(vyPxPerS);
            buffer.put(',');
            buffer.put(segment);
            buffer.put('\n');
            int length = buffer.size - start;
            System.arraycopy(buffer.bytes, start, texts, from, length);
            textLength[slot] = length;
            textSegment[slot] = segment;
            textVx[slot] = vxPxPerS;
            textVy[slot] = vyPxPerS;
            return;
        }
        buffer.put(texts, from, textLength[slot]);
    }

    /**
     * Writes all rows that are still buffered; these are whole rows.
     *
     * @throws IOException if they cannot be written
     */
    public void flush() throws IOException {
        buffer.flush();
        out.flush();
    }

    /** Writes the rows that are still buffered and closes the stream. */
    @Override
    public void close() throws IOException {
        try (out) {
            buffer.flush();
        }
    }
}
