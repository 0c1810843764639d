package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.io.IOException;

/**
 * Base class of the readers of Prophesee's RAW versions. It takes whole words from the file, searches for the first
 * word that gives the time, undoes overflows of time, and expands vectors of events. The rest of a vector waits where a
 * batch is full. Holds one file buffer.
 */
abstract class EvtReader extends RecordingReader {
    private final int wordBytes;
    private final long rangeUs;
    private final long wrapStepUs;

    /** Time given by the latest high bits, in µs; negative before the first ones. */
    long highUs = -1;

    // The vector whose events did not all fit into the batch.
    int vectorMask;
    int vectorX;
    int vectorY;
    int vectorPolarity;
    long vectorUs;

    /**
     * Makes a reader at the first word.
     *
     * @param wordBytes size of a word
     * @param timeBits number of bits after which time overflows
     * @param wrapStepUs the smallest step back of the high bits that is an overflow, in µs
     */
    EvtReader(RecordingFile file, RecordingOptions options, String formatName, ChipChoice choice, int wordBytes,
              int timeBits, long wrapStepUs) {
        super(file, options, formatName, choice.name(), choice.sensor());
        this.wordBytes = wordBytes;
        this.rangeUs = 1L << timeBits;
        this.wrapStepUs = wrapStepUs;
    }

    /** The type of the word at a place of the buffer. */
    abstract int typeAt(int p);

    /**
     * Decodes buffered words from {@code file.position} on until the batch is full or no whole word is left. Delivers
     * the events and advances the position.
     *
     * @param n events that are in the batch already
     */
    abstract void decodeWords(EventBatch batch, int n) throws MalformedRecordingException;

    @Override
    final boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (vectorMask == 0 && !file.require(wordBytes)) {
            if (file.available() > 0) {
                throw malformed(eventNumber(0), file.offset(), "truncated, a word must have " + wordBytes
                        + " bytes but had " + file.available());
            }
            return false;
        }
        if (highUs < 0) {
            passOverWhatHasNoTime();
        } else {
            decodeWords(batch, emit(batch, 0, file.position));
        }
        return true;
    }

    /** Skips to the first word with the high bits of time: the words before it cannot be dated. */
    private void passOverWhatHasNoTime() {
        int p = file.position;
        while (p + wordBytes <= file.limit && typeAt(p) != EvtFormat.TIME_HIGH) {
            long offset = offsetOf(p);
            otherRecords++;
            addFault("timeless", () -> at(eventNumber(0), offset) + "malformed, a recording must begin with a word of "
                    + "time; the words before it were passed over");
            p += wordBytes;
        }
        file.position = p;
        if (p + wordBytes <= file.limit) {
            highUs = 0;
        }
    }

    /** Sets the high bits of time, as the word holds them but in µs. */
    final void timeHigh(long rawUs) {
        highUs = rawUs;
    }

    @Override
    final long step(long fromUs, long toUs) {
        return overflowingStep(fromUs, toUs, rangeUs, wrapStepUs);
    }

    /**
     * Adds the remaining events of the current vector to the batch, as far as they fit.
     *
     * @param n events that are in the batch already
     * @param p where the word lies in the buffer, for messages
     * @return events that are in the batch now
     */
    final int emit(EventBatch batch, int n, int p) throws MalformedRecordingException {
        int mask = vectorMask;
        if (mask == 0) {
            return n;
        }
        int next = n;
        int capacity = batch.capacity();
        int width = sensor().width();
        int height = sensor().height();
        long time = vectorUs;
        while (mask != 0 && next < capacity) {
            int column = vectorX + Integer.numberOfTrailingZeros(mask);
            mask &= mask - 1;
            if (column >= width || vectorY >= height) {
                outside(column, vectorY, eventNumber(next), offsetOf(p));
                continue;
            }
            note(next, offsetOf(p));
            batch.timeUs[next] = time;
            batch.x[next] = (short) column;
            batch.y[next] = (short) vectorY;
            batch.polarity[next] = (byte) vectorPolarity;
            next++;
        }
        vectorMask = mask;
        return next;
    }
}
