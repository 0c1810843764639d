package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Base class of the readers of all formats. A reader delivers the change events (DVS) of a recording in the order of
 * the file, with x right, y down and time that never falls. Records of other kinds are counted. A fault that loses
 * nothing else is kept in {@link #faults()}. Damage that ends the reading is thrown, after every event before it was
 * delivered.
 *
 * <p>For use by one thread. The package description states how much memory a reader holds.
 */
public abstract class RecordingReader implements EventSource {
    /** How many events are decoded at once while others wait for the events after them. */
    private static final int BEHIND = 4096;

    final RecordingFile file;

    long apsSamples;
    long frames;
    long imuSamples;
    long triggers;
    long invalid;
    long otherRecords;
    /** Records with bits that no recorder sets; their readable part was used. */
    long malformedRecords;
    /** Receiver of IMU samples; null where there is none. */
    Consumer<ImuSample> imuReceiver;
    /** Receiver of frames; null where there is none. */
    Consumer<GreyFrame> frameReceiver;

    private final String formatName;
    private final String chipName;
    private final SensorSize sensor;
    private boolean chipIsAsked;
    private final List<String> notes = new ArrayList<>();
    private final Faults faults = new Faults();
    private final OutsideEvents outside;
    private final TimeFaults timeFaults;
    private final TimeOrder order;
    /** Takes the events that are decoded while earlier events wait. */
    private EventBatch behind;
    /** Number and place of each event of the batch that is being decoded. */
    private long[] numbers = new long[0];
    private long[] places = new long[0];
    /** Events decoded. Fewer are delivered where times are damaged, or where some events wait. */
    private long decoded;
    private long events;
    private boolean ended;
    private boolean closed;
    private EventSourceException damage;

    RecordingReader(RecordingFile file, RecordingOptions options, String formatName, String chipName,
                    SensorSize sensor) {
        this.file = file;
        this.formatName = formatName;
        this.chipName = chipName;
        this.sensor = sensor;
        outside = new OutsideEvents(sensor);
        timeFaults = new TimeFaults(this, options.strict());
        order = new TimeOrder(this, timeFaults);
    }

    /**
     * Decodes the next events into the empty batch, with the times that the file holds, in whatever order, and calls
     * {@link #note} for each event. Events that were passed to {@link #deliver} before an exception are delivered
     * first; then the exception is thrown.
     *
     * @return false at the end of the recording; true where more may follow, even if the batch is still empty
     */
    abstract boolean decode(EventBatch batch) throws EventSourceException, IOException;

    /**
     * Returns how far the clock advanced from one time of the file to another, in µs; negative where it stepped back.
     * Formats with clocks of few bits, which start again after an overflow, override this rule.
     */
    long step(long fromUs, long toUs) {
        long step = toUs - fromUs;
        boolean overflows = ((toUs ^ fromUs) & (toUs ^ step)) < 0;
        return !overflows ? step : toUs > fromUs ? Long.MAX_VALUE : Long.MIN_VALUE;
    }

    /**
     * Returns the step of a clock that starts again at 0.
     *
     * @param rangeUs time after which the clock starts again
     * @param leastBackUs the smallest step back that is an overflow
     */
    final long overflowingStep(long fromUs, long toUs, long rangeUs, long leastBackUs) {
        long step = toUs - fromUs;
        if (step <= -leastBackUs) {
            return step + rangeUs;
        }
        // an event from before the overflow that comes after it
        return step >= leastBackUs && timeWraps() > 0 ? step - rangeUs : step;
    }

    @Override
    public final SensorSize sensor() {
        return sensor;
    }

    /** {@return the format and its version, such as "AEDAT 2.0"} */
    public final String formatName() {
        return formatName;
    }

    /** {@return the sensor's name in the recording, or else the caller's; empty where only the size is known} */
    public final Optional<String> chip() {
        return Optional.ofNullable(chipName);
    }

    /** {@return how packets are packed, such as "LZ4"; empty for formats without compression} */
    public Optional<String> compression() {
        return Optional.empty();
    }

    /** {@return the counts up to the end of the last batch; while a batch is read, up to the events decoded for it} */
    public final RecordingCounts counts() {
        return new RecordingCounts(events, apsSamples, frames, imuSamples, triggers, invalid, outside.count(),
                timeFaults.stepsBack(), timeFaults.wraps(), otherRecords, malformedRecords, timeFaults.damagedTimes(),
                timeFaults.restarts());
    }

    /**
     * Delivers IMU samples from now on, each from within {@link #next} and before the events that follow it in the
     * file. Only AEDAT 2.0 recordings of DAVIS cameras deliver them; other formats only count theirs.
     *
     * @param receiver is called while batches are read, in the order of the file
     */
    public final void onImuSample(Consumer<ImuSample> receiver) {
        imuReceiver = receiver;
    }

    /**
     * Delivers grey-level frames from now on, each from within {@link #next}; a batch may hold events from before and
     * after the frame. AEDAT 2.0 recordings of DAVIS cameras and AEDAT 4.0 recordings deliver them; others only count
     * theirs.
     *
     * @param receiver is called while batches are read, in the order of the file
     */
    public final void onFrame(Consumer<GreyFrame> receiver) {
        frameReceiver = receiver;
    }

    /** {@return how many bytes of the file have been read; bytes that are still buffered do not count} */
    public final long bytesRead() {
        return file.offset();
    }

    /** {@return the time of the first delivered event, in µs; 0 before there was one} */
    public final long firstTimeUs() {
        return order.firstUs();
    }

    /** {@return the time of the last delivered event, in µs; 0 before there was one} */
    public final long lastTimeUs() {
        return order.lastUs();
    }

    /**
     * {@return the faults found so far that did not end the reading} There is one line per kind of fault, with the
     * place of the first one and their number. Empty for a faultless recording.
     */
    public final List<String> faults() {
        return faults.lines();
    }

    /** {@return notes for the user that are not faults, such as that an option was not needed} */
    public final List<String> notes() {
        return List.copyOf(notes);
    }

    @Override
    public final boolean next(EventBatch batch) throws EventSourceException {
        batch.clear();
        try {
            while (batch.size() == 0 && (!isOver() || order.waiting() > 0)) {
                if (order.waiting() == 0) {
                    decodeInto(batch);
                } else {
                    if (behind == null) {
                        behind = new EventBatch(BEHIND);
                    }
                    int before = order.waiting();
                    order.putWaiting(batch, isOver());
                    if (batch.size() == 0 && order.waiting() == before && !isOver()) {
                        decodeInto(behind);
                    }
                }
            }
        } catch (MalformedRecordingException e) {
            // a time out of order, where the reading is strict
            damage = e;
            order.end();
        }
        events += batch.size();
        if (batch.size() > 0) {
            return true;
        }
        if (damage == null) {
            damage = disorder();
        }
        if (damage != null) {
            throw damage;
        }
        return false;
    }

    private boolean isOver() {
        return ended || damage != null;
    }

    private void decodeInto(EventBatch batch) {
        batch.clear();
        if (numbers.length < batch.capacity()) {
            numbers = new long[batch.capacity()];
            places = new long[batch.capacity()];
        }
        try {
            ended = !decode(batch);
        } catch (EventSourceException e) {
            damage = e;
        } catch (IOException e) {
            damage = new EventSourceException("[" + file.name + "] event " + eventNumber(0) + " at byte "
                    + file.offset() + ": cannot be read: " + Printable.of(e.toString()), e);
        }
        order.takeRegular(batch, numbers, places);
        if (isOver()) {
            lookForGrowth();
        }
    }

    /**
     * Reports where the file has grown since it was opened. Someone may still be writing it; the events read are then
     * only a part, however well the reading ends.
     */
    private void lookForGrowth() {
        try {
            long size = file.size();
            if (file.sizeAtFirst() > 0 && size > file.sizeAtFirst()) {
                addFault("growth", () -> at(eventNumber(0), file.offset()) + "the file must not grow while it is read "
                        + "but had " + file.sizeAtFirst() + " bytes at first and has " + size + " now");
            }
        } catch (IOException e) {
            // the events read stay valid
            return;
        }
    }

    /** The exception for a recording with too many events out of order; null where there are few. */
    private EventSourceException disorder() {
        String disorder = closed ? null : timeFaults.disorder(decoded);
        return disorder == null ? null : new MalformedRecordingException("[" + file.name + "] " + disorder);
    }

    /** Releases the resources that a format holds besides the file. */
    void release() {
    }

    @Override
    public final void close() {
        ended = true;
        closed = true;
        order.end();
        release();
        try {
            file.close();
        } catch (IOException e) {
            // Nothing was written, so a failure to close loses nothing.
            return;
        }
    }

    /** Keeps a note for the user that is no fault of the recording. */
    final void addNote(String note) {
        notes.add(note);
    }

    /** Keeps a fault that does not end the reading; faults are counted by kind. */
    final void addFault(String kind, Supplier<String> message) {
        faults.add(kind, message);
    }

    /** Notes the number and place of event n of the batch, before the event is decoded further. */
    final void note(int n, long offset) {
        numbers[n] = eventNumber(n);
        places[n] = offset;
    }

    /** Notes that the first n entries of the batch are decoded. */
    final void deliver(EventBatch batch, int n) {
        batch.setSize(n);
        decoded += n;
    }

    /**
     * The number, from 0, of the event that follows all events decoded, all events dropped and n more of this batch.
     */
    final long eventNumber(int n) {
        return decoded + outside.count() + invalid + n;
    }

    /** Converts the time of a record other than an event to the clock of the delivered events. */
    final long timeOf(long fileUs) {
        return order.timeOf(fileUs);
    }

    /** Counts an overflow of the clock. */
    final void timeWrapped() {
        timeFaults.wrapped();
    }

    /** How many overflows of the clock there were. */
    final long timeWraps() {
        return timeFaults.wraps();
    }

    /** Counts an event outside the sensor, which is not delivered. */
    final void outside(int x, int y, long event, long offset) {
        outside.add(x, y);
        addFault("outside", () -> at(event, offset) + sensor.brokenRule(x, y));
    }

    /** Notes that the caller named the sensor, not the recording. */
    final void chipIsAsked() {
        chipIsAsked = true;
    }

    /** Whether the caller named the sensor. */
    final boolean isChipAsked() {
        return chipIsAsked;
    }

    /**
     * Checks that all but a few of the events read so far lie on the sensor.
     *
     * @throws MalformedRecordingException where too many lie outside
     */
    final void checkPixels(String asked) throws MalformedRecordingException {
        String misfit = outside.misfit(asked, decoded);
        if (misfit != null) {
            throw new MalformedRecordingException("[" + file.name + "] " + misfit);
        }
    }

    /** Converts a place of the buffer to a place in the file. */
    final long offsetOf(int p) {
        return file.offset() - file.position + p;
    }

    /** Makes the exception for damage at a place. */
    final MalformedRecordingException malformed(long event, long offset, String rule) {
        return new MalformedRecordingException(at(event, offset) + rule);
    }

    /** Names a place in the form that all messages share. */
    String at(long event, long offset) {
        return "[" + file.name + "] event " + event + " at byte " + offset + ": ";
    }
}
