package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
    final RecordingFile file;
    final boolean strict;

    /** Greatest time delivered so far. */
    long lastTimeUs = Long.MIN_VALUE;
    long events;
    long apsSamples;
    long frames;
    long imuSamples;
    long triggers;
    long invalid;
    long outsideSensor;
    long stepsBack;
    long timeWraps;
    long otherRecords;
    /** Gets IMU samples; null where no one wants them. */
    Consumer<ImuSample> imuReceiver;
    /** Gets frames; null where no one wants them. */
    Consumer<GreyFrame> frameReceiver;

    private final String formatName;
    private final String chipName;
    private final SensorSize sensor;
    private final Map<String, Fault> faults = new LinkedHashMap<>();
    private long firstTimeUs;
    private boolean ended;
    private EventSourceException damage;

    /** One kind of fault: where it was met first, and how often. */
    private static final class Fault {
        final String first;
        long count = 1;

        Fault(String first) {
            this.first = first;
        }
    }

    RecordingReader(RecordingFile file, RecordingOptions options, String formatName, String chipName,
                    SensorSize sensor) {
        this.file = file;
        this.strict = options.strict();
        this.formatName = formatName;
        this.chipName = chipName;
        this.sensor = sensor;
    }

    /**
     * Decodes what follows into the empty batch. What was passed to {@link #deliver} before an exception is
     * delivered, and then the exception is thrown.
     *
     * @return false at the end of the recording; true where more may follow, even if the batch is still empty
     */
    abstract boolean decode(EventBatch batch) throws EventSourceException, IOException;

    @Override
    public final SensorSize sensor() {
        return sensor;
    }

    /** The format and its version, such as "AEDAT 2.0". */
    public final String formatName() {
        return formatName;
    }

    /** How the recording, or else the caller, names the sensor; empty where only its size is known. */
    public final Optional<String> chip() {
        return Optional.ofNullable(chipName);
    }

    /** How packets are packed, such as "LZ4"; empty for formats that know no compression. */
    public Optional<String> compression() {
        return Optional.empty();
    }

    /** What has been met up to the end of the last batch; in a batch's middle, up to what was decoded for it. */
    public final RecordingCounts counts() {
        return new RecordingCounts(events, apsSamples, frames, imuSamples, triggers, invalid, outsideSensor, stepsBack,
                timeWraps, otherRecords);
    }

    /**
     * Delivers IMU samples from now on, each from within {@link #next} and before the events that follow it in the
     * file. Only AEDAT 2.0 recordings of DAVIS cameras deliver them; other formats count theirs.
     */
    public final void onImuSample(Consumer<ImuSample> receiver) {
        imuReceiver = receiver;
    }

    /**
     * Delivers grey-level frames from now on, each from within {@link #next}; a batch may hold events of before and
     * after. AEDAT 2.0 recordings of DAVIS cameras and AEDAT 4.0 recordings deliver them, others only count theirs.
     */
    public final void onFrame(Consumer<GreyFrame> receiver) {
        frameReceiver = receiver;
    }

    /** How far into the file the reading is, in bytes; what is still buffered is not counted. */
    public final long bytesRead() {
        return file.offset();
    }

    /** Time of the first event delivered, µs; 0 before one was. */
    public final long firstTimeUs() {
        return firstTimeUs;
    }

    /** Time of the last event delivered, µs; 0 before one was. */
    public final long lastTimeUs() {
        return events == 0 ? 0 : lastTimeUs;
    }

    /**
     * What was found wrong so far without ending the reading: one line a kind of fault, with the place of the first and
     * how many there were. Empty for a faultless recording.
     */
    public final List<String> faults() {
        List<String> lines = new ArrayList<>();
        for (Fault fault : faults.values()) {
            lines.add(fault.count == 1 ? fault.first : fault.first + " (the first of " + fault.count + ")");
        }
        return List.copyOf(lines);
    }

    @Override
    public final boolean next(EventBatch batch) throws EventSourceException {
        batch.clear();
        while (damage == null && !ended && batch.size() == 0) {
            try {
                ended = !decode(batch);
            } catch (EventSourceException e) {
                damage = e;
            } catch (IOException e) {
                damage = new EventSourceException("[" + file.name + "] event " + eventNumber(0) + " at byte "
                        + file.offset() + ": cannot be read: " + Printable.of(e.toString()), e);
            }
        }
        if (batch.size() > 0) {
            return true;
        }
        if (damage != null) {
            throw damage;
        }
        return false;
    }

    /** Gives back what a format holds beside the file. */
    void release() {
    }

    @Override
    public final void close() {
        ended = true;
        release();
        try {
            file.close();
        } catch (IOException e) {
            // Nothing was written, so a failure to close loses nothing.
            return;
        }
    }

    /** Keeps a fault that does not end the reading; the kind is what faults are counted by. */
    final void addFault(String kind, Supplier<String> message) {
        Fault fault = faults.get(kind);
        if (fault == null) {
            faults.put(kind, new Fault(message.get()));
        } else {
            fault.count++;
        }
    }

    /** Notes that the first n entries of the batch are decoded, the last of them at the given time. */
    final void deliver(EventBatch batch, int n, long newLastTimeUs) {
        if (events == 0 && n > 0) {
            firstTimeUs = batch.timeUs[0];
        }
        batch.setSize(n);
        events += n;
        lastTimeUs = newLastTimeUs;
    }

    /** The number, from 0, of the event that follows those delivered, those dropped and n more of this batch. */
    final long eventNumber(int n) {
        return events + outsideSensor + invalid + n;
    }

    /**
     * The time to deliver an event with whose own time fell below {@link #lastTimeUs}.
     *
     * @throws MalformedRecordingException if strict
     */
    final long stepBack(long timeUs, long event, long offset) throws MalformedRecordingException {
        if (strict) {
            throw malformed(event, offset, "malformed, " + timeRule(timeUs));
        }
        stepsBack++;
        addFault("time", () -> at(event, offset) + timeRule(timeUs));
        return lastTimeUs;
    }

    private String timeRule(long timeUs) {
        return "time must not fall below " + lastTimeUs + " us but was " + timeUs + " us";
    }

    /** Counts an event outside the sensor, which is not delivered. */
    final void outside(int x, int y, long event, long offset) {
        outsideSensor++;
        addFault("outside", () -> at(event, offset) + (x < 0 || x >= sensor.width()
                ? "x must be smaller than width " + sensor.width() + " but was " + x
                : "y must be smaller than height " + sensor.height() + " but was " + y));
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
