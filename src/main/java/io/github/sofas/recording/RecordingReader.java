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
 * A recording that is being read. It delivers the change events (DVS) in the order of the file, with x right, y down
 * and time that never falls; other kinds are counted. Whatever is wrong but loses nothing else is kept in
 * {@link #faults()}; damage that ends the reading is thrown, after every event before it was delivered.
 *
 * <p>Used by one thread. What it holds in memory is written in the package's description.
 */
public abstract class RecordingReader implements EventSource {
    /** Events that are decoded at once where some wait for those behind them. */
    private static final int BEHIND = 4096;

    final RecordingFile file;

    long apsSamples;
    long frames;
    long imuSamples;
    long triggers;
    long invalid;
    long otherRecords;
    /** Records with bits that no recorder sets; what could be read of them was used. */
    long malformedRecords;
    /** Gets IMU samples; null where no one wants them. */
    Consumer<ImuSample> imuReceiver;
    /** Gets frames; null where no one wants them. */
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
    /** Takes what is decoded while events wait that come before it. */
    private EventBatch behind;
    /** Number and place of each event of the batch that is being decoded. */
    private long[] numbers = new long[0];
    private long[] places = new long[0];
    /** Events decoded; those that are delivered are fewer where times are damaged, or where some wait. */
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
     * Decodes what follows into the empty batch, with the times that the file holds, in whatever order; {@link #note}
     * is called for each event. What was passed to {@link #deliver} before an exception is delivered, and then the
     * exception is thrown.
     *
     * @return false at the end of the recording; true where more may follow, even if the batch is still empty
     */
    abstract boolean decode(EventBatch batch) throws EventSourceException, IOException;

    /**
     * How far the clock went from one time of the file to another, in µs: less than 0 where it stepped back. Clocks of
     * few bits, which start again after an overflow, have a rule of their own.
     */
    long step(long fromUs, long toUs) {
        long step = toUs - fromUs;
        boolean overflows = ((toUs ^ fromUs) & (toUs ^ step)) < 0;
        return !overflows ? step : toUs > fromUs ? Long.MAX_VALUE : Long.MIN_VALUE;
    }

    /**
     * The step of a clock that begins again with 0.
     *
     * @param rangeUs after which it does
     * @param leastBackUs the smallest step back that is an overflow
     */
    final long overflowingStep(long fromUs, long toUs, long rangeUs, long leastBackUs) {
        long step = toUs - fromUs;
        if (step <= -leastBackUs) {
            return step + rangeUs;
        }
        // an event of before the overflow that came after it
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

    /** {@return how the recording, or else the caller, names the sensor; empty where only its size is known} */
    public final Optional<String> chip() {
        return Optional.ofNullable(chipName);
    }

    /** {@return how packets are packed, such as "LZ4"; empty for formats that know no compression} */
    public Optional<String> compression() {
        return Optional.empty();
    }

    /**
     * {@return what has been met up to the end of the last batch; in a batch's middle, up to what was decoded for it}
     */
    public final RecordingCounts counts() {
        return new RecordingCounts(events, apsSamples, frames, imuSamples, triggers, invalid, outside.count(),
                timeFaults.stepsBack(), timeFaults.wraps(), otherRecords, malformedRecords, timeFaults.damagedTimes(),
                timeFaults.restarts());
    }

    /**
     * Delivers IMU samples from now on, each from within {@link #next} and before the events that follow it in the
     * file. Only AEDAT 2.0 recordings of DAVIS cameras deliver them; other formats count theirs.
     *
     * @param receiver is called while batches are read, in the order of the file
     */
    public final void onImuSample(Consumer<ImuSample> receiver) {
        imuReceiver = receiver;
    }

    /**
     * Delivers grey-level frames from now on, each from within {@link #next}; a batch may hold events of before and
     * after. AEDAT 2.0 recordings of DAVIS cameras and AEDAT 4.0 recordings deliver them, others only count theirs.
     *
     * @param receiver is called while batches are read, in the order of the file
     */
    public final void onFrame(Consumer<GreyFrame> receiver) {
        frameReceiver = receiver;
    }

    /** {@return how far into the file the reading is, in bytes; what is still buffered is not counted} */
    public final long bytesRead() {
        return file.offset();
    }

    /** {@return the time of the first event delivered, µs; 0 before one was} */
    public final long firstTimeUs() {
        return order.firstUs();
    }

    /** {@return the time of the last event delivered, µs; 0 before one was} */
    public final long lastTimeUs() {
        return order.lastUs();
    }

    /**
     * {@return what was found wrong so far without ending the reading} One line per kind of fault, with the place of
     * the first and their number. Empty for a faultless recording.
     */
    public final List<String> faults() {
        return faults.lines();
    }

    /** {@return what the user should know beside the faults, such as that an option was not needed} */
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

    /** Someone may still be writing: what was read is a part then, however well it ends. */
    private void lookForGrowth() {
        try {
            long size = file.size();
            if (file.sizeAtFirst() > 0 && size > file.sizeAtFirst()) {
                addFault("growth", () -> at(eventNumber(0), file.offset()) + "the file must not grow while it is read "
                        + "but had " + file.sizeAtFirst() + " bytes at first and has " + size + " now");
            }
        } catch (IOException e) {
            // what was read was read
            return;
        }
    }

    /** What is wrong with a recording of which too many events are out of order; null where they are not. */
    private EventSourceException disorder() {
        String disorder = closed ? null : timeFaults.disorder(decoded);
        return disorder == null ? null : new MalformedRecordingException("[" + file.name + "] " + disorder);
    }

    /** Gives back what a format holds beside the file. */
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

    /** Keeps what the user should know, and what is no fault of the recording. */
    final void addNote(String note) {
        notes.add(note);
    }

    /** Keeps a fault that does not end the reading; the kind is what faults are counted by. */
    final void addFault(String kind, Supplier<String> message) {
        faults.add(kind, message);
    }

    /** Notes where event n of the batch lies, before it is decoded further. */
    final void note(int n, long offset) {
        numbers[n] = eventNumber(n);
        places[n] = offset;
    }

    /** Notes that the first n entries of the batch are decoded. */
    final void deliver(EventBatch batch, int n) {
        batch.setSize(n);
        decoded += n;
    }

    /** The number, from 0, of the event that follows those decoded, those dropped and n more of this batch. */
    final long eventNumber(int n) {
        return decoded + outside.count() + invalid + n;
    }

    /** The time of something beside the events, on the clock of those. */
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

    /** Notes that the sensor is the one that the caller named, and not one that the recording names. */
    final void chipIsAsked() {
        chipIsAsked = true;
    }

    /** Whether the sensor is the one that the caller named. */
    final boolean isChipAsked() {
        return chipIsAsked;
    }

    /**
     * Checks that the events read so far lie on the sensor, but for few.
     *
     * @throws MalformedRecordingException where they do not
     */
    final void checkPixels(String asked) throws MalformedRecordingException {
        String misfit = outside.misfit(asked, decoded);
        if (misfit != null) {
            throw new MalformedRecordingException("[" + file.name + "] " + misfit);
        }
    }

    /** Where in the file a place of its buffer lies. */
    final long offsetOf(int p) {
        return file.offset() - file.position + p;
    }

    /** Makes the exception for damage at a place. */
    final MalformedRecordingException malformed(long event, long offset, String rule) {
        return new MalformedRecordingException(at(event, offset) + rule);
    }

    /** Names a place, in the grammar of all messages. */
    String at(long event, long offset) {
        return "[" + file.name + "] event " + event + " at byte " + offset + ": ";
    }
}
