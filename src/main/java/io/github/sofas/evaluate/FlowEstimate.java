package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Labelling;
import io.github.sofas.simulate.SimulatedRecording;
import java.util.Arrays;

/** The labels that a method gives to the events of a recording: velocity and segment, gathered batch by batch. */
public final class FlowEstimate {
    private static final int BATCH = 4096;

    private float[] vxPxPerS;
    private float[] vyPxPerS;
    private int[] segment;
    private int size;

    /** Makes an empty estimate. */
    public FlowEstimate() {
        this(new float[1024], new float[1024], new int[1024], 0);
    }

    private FlowEstimate(float[] vxPxPerS, float[] vyPxPerS, int[] segment, int size) {
        this.vxPxPerS = vxPxPerS;
        this.vyPxPerS = vyPxPerS;
        this.segment = segment;
        this.size = size;
    }

    /**
     * Makes an estimate on complete arrays, which are held, not copied.
     *
     * @param vxPxPerS velocity to the right in px/s
     * @param vyPxPerS velocity downwards in px/s
     * @param segment id of the segment, 0 if the event has no flow
     * @return the estimate
     * @throws IllegalArgumentException if the lengths of the arrays differ
     */
    public static FlowEstimate of(float[] vxPxPerS, float[] vyPxPerS, int[] segment) {
        if (vxPxPerS.length != segment.length || vyPxPerS.length != segment.length) {
            throw new IllegalArgumentException("estimate arrays must have one length but have " + vxPxPerS.length
                    + ", " + vyPxPerS.length + " and " + segment.length);
        }
        return new FlowEstimate(vxPxPerS, vyPxPerS, segment, segment.length);
    }

    /**
     * Labels a simulated recording with a method that labels each event at once.
     *
     * @param recording the recording to label
     * @param method a method made for the recording's sensor; it is not reset first
     * @return the estimate
     */
    public static FlowEstimate of(SimulatedRecording recording, EventLabeller method) {
        FlowEstimate estimate = new FlowEstimate();
        estimate.label(recording, method, recording.size());
        return estimate;
    }

    /**
     * Labels a simulated recording with a method that may label events later than it takes them.
     *
     * @param recording the recording to label
     * @param method a method made for the recording's sensor, which has not yet seen any event
     * @return the estimate
     */
    public static FlowEstimate of(SimulatedRecording recording, Labelling method) {
        FlowEstimate estimate = new FlowEstimate();
        EventBatch batch = new EventBatch(BATCH);
        EventBatch labelled = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        for (int from = 0; from < recording.size(); from += BATCH) {
            fill(batch, recording, from, Math.min(BATCH, recording.size() - from));
            method.add(batch);
            while (method.next(labelled, output)) {
                estimate.append(output, labelled.size());
            }
        }
        method.finish();
        while (method.next(labelled, output)) {
            estimate.append(output, labelled.size());
        }
        return estimate;
    }

    private static void fill(EventBatch batch, SimulatedRecording recording, int from, int count) {
        System.arraycopy(recording.timeUs, from, batch.timeUs, 0, count);
        System.arraycopy(recording.x, from, batch.x, 0, count);
        System.arraycopy(recording.y, from, batch.y, 0, count);
        System.arraycopy(recording.polarity, from, batch.polarity, 0, count);
        batch.setSize(count);
    }

    /**
     * Labels the next events of a simulated recording, and appends their labels.
     *
     * @param recording the recording to label
     * @param method the method that has labelled all events of this estimate
     * @param until number of the event to stop before
     */
    public void label(SimulatedRecording recording, EventLabeller method, int until) {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput output = new FlowOutput(BATCH);
        while (size < until) {
            int count = Math.min(BATCH, until - size);
            fill(batch, recording, size, count);
            method.process(batch, output);
            append(output, count);
        }
    }

    /**
     * Appends the labels of a batch.
     *
     * @param output the labels that the method wrote
     * @param count number of entries of the output that belong to events
     */
    public void append(FlowOutput output, int count) {
        int needed = size + count;
        if (needed > segment.length) {
            int capacity = Math.max(needed, size + (size >> 1));
            vxPxPerS = Arrays.copyOf(vxPxPerS, capacity);
            vyPxPerS = Arrays.copyOf(vyPxPerS, capacity);
            segment = Arrays.copyOf(segment, capacity);
        }
        System.arraycopy(output.vxPxPerS, 0, vxPxPerS, size, count);
        System.arraycopy(output.vyPxPerS, 0, vyPxPerS, size, count);
        System.arraycopy(output.segment, 0, segment, size, count);
        size = needed;
    }

    /** {@return the number of events} */
    public int size() {
        return size;
    }

    /**
     * {@return the velocity of event i to the right in px/s; valid only if {@link #hasFlow}}
     *
     * @param i number of the event, from 0
     */
    public float vxPxPerS(int i) {
        return vxPxPerS[i];
    }

    /**
     * {@return the velocity of event i downwards in px/s; valid only if {@link #hasFlow}}
     *
     * @param i number of the event, from 0
     */
    public float vyPxPerS(int i) {
        return vyPxPerS[i];
    }

    /**
     * {@return the id of the segment of event i, 0 if the event has none}
     *
     * @param i number of the event, from 0
     */
    public int segment(int i) {
        return segment[i];
    }

    /**
     * {@return whether event i was given a velocity}
     *
     * @param i number of the event, from 0
     */
    public boolean hasFlow(int i) {
        return segment[i] != 0;
    }
}
