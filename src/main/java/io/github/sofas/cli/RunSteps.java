package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.RunSummary;
import io.github.sofas.export.WithoutFlow;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SmoothedSofas;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.report.ReportCollector;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Reads, labels and writes each batch of a recording, and measures the time of these steps. Each step has its own
 * figures. With look-ahead, events are given back later than they are read.
 */
abstract class RunSteps implements BatchPipeline.Steps {
    private final RecordingReader reader;
    private final RunTables tables;
    private final ReportCollector report;
    private final RunProgress progress;
    private final List<Segment> ended;
    private final WithoutFlow withoutFlow;
    private EventSourceException damage;
    private Exception reportFailure;
    private long decodeNs;
    private long engineNs;
    private long lookAheadNs;
    private long outputNs;
    private long eventsWithFlow;
    private long bytesShown;

    private RunSteps(RecordingReader reader, List<Segment> ended, RunTables tables, ReportCollector report,
                     RunProgress progress) {
        this.reader = reader;
        this.ended = ended;
        this.tables = tables;
        this.report = report;
        this.progress = progress;
        withoutFlow = new WithoutFlow(reader.sensor());
    }

    /**
     * Creates the steps of one run.
     *
     * @param report also receives the labelled events; null for no report
     */
    static RunSteps of(RecordingReader reader, MethodChoice method, RunTables tables, ReportCollector report,
                       RunProgress progress) {
        List<Segment> ended = new ArrayList<>();
        return method.looksAhead()
            ? new Ahead(method.ahead(reader.sensor(), ended::add), reader, ended, tables, report, progress)
            : new AtOnce(method.make(reader.sensor(), ended::add), reader, ended, tables, report, progress);
    }

    /** Labels without look-ahead: each batch has its final labels at once. */
    private static final class AtOnce extends RunSteps {
        private final EventLabeller labeller;

        AtOnce(EventLabeller labeller, RecordingReader reader, List<Segment> ended, RunTables tables,
               ReportCollector report, RunProgress progress) {
            super(reader, ended, tables, report, progress);
            this.labeller = labeller;
        }

        @Override
        public void helpedBy(Consumer<Runnable> helper) {
            labeller.helpedBy(helper);
        }

        @Override
        void labelNow(BatchPipeline.Slot slot) {
            labeller.process(slot.events, slot.flow);
        }

        @Override
        public void write(BatchPipeline.Slot slot) throws IOException {
            writeRows(slot);
        }

        @Override
        public void finish(BatchPipeline.Slot slot) {
            // nothing is held back
        }

        @Override
        List<Segment> living() {
            return labeller.segments();
        }
    }

    /**
     * Labels with look-ahead: the final labels of a batch need what follows it. Looking at events from both sides is a
     * part of writing.
     */
    private static final class Ahead extends RunSteps {
        private final SmoothedSofas sofas;

        Ahead(SmoothedSofas sofas, RecordingReader reader, List<Segment> ended, RunTables tables,
              ReportCollector report, RunProgress progress) {
            super(reader, ended, tables, report, progress);
            this.sofas = sofas;
        }

        @Override
        public void helpedBy(Consumer<Runnable> helper) {
            sofas.helpedBy(helper);
        }

        @Override
        void labelNow(BatchPipeline.Slot slot) {
            sofas.label(slot.events, slot.causal);
        }

        @Override
        public void write(BatchPipeline.Slot slot) throws IOException {
            look(() -> sofas.add(slot.causal), slot);
        }

        @Override
        public void finish(BatchPipeline.Slot slot) throws IOException {
            slot.bytesRead = super.bytesShown;
            look(sofas::finish, slot);
        }

        /** Runs a step, then writes the events that can be labelled after it, in place of those that were read. */
        private void look(Runnable step, BatchPipeline.Slot slot) throws IOException {
            long start = System.nanoTime();
            step.run();
            boolean more = sofas.next(slot.events, slot.flow);
            super.lookAheadNs += System.nanoTime() - start;
            while (more) {
                writeRows(slot);
                start = System.nanoTime();
                more = sofas.next(slot.events, slot.flow);
                super.lookAheadNs += System.nanoTime() - start;
            }
        }

        @Override
        List<Segment> living() {
            return sofas.segments();
        }
    }

    @Override
    public boolean read(BatchPipeline.Slot slot) {
        long start = System.nanoTime();
        boolean more = false;
        try {
            more = reader.next(slot.events);
        } catch (EventSourceException e) {
            damage = e;
        }
        slot.bytesRead = reader.bytesRead();
        decodeNs += System.nanoTime() - start;
        return more;
    }

    @Override
    public void label(BatchPipeline.Slot slot) {
        long start = System.nanoTime();
        labelNow(slot);
        engineNs += System.nanoTime() - start;
    }

    /** Labels a batch; the caller measures the time. */
    abstract void labelNow(BatchPipeline.Slot slot);

    /** The segments that are alive. */
    abstract List<Segment> living();

    /** Writes the labelled events of a slot, and counts them. */
    final void writeRows(BatchPipeline.Slot slot) throws IOException {
        long start = System.nanoTime();
        tables.write(slot.events, slot.flow);
        addToReport(slot);
        outputNs += System.nanoTime() - start;
        withoutFlow.add(slot.events, slot.flow);
        int withFlow = countWithFlow(slot.events, slot.flow);
        eventsWithFlow += withFlow;
        progress.add(slot.bytesRead - bytesShown, slot.events.size(), withFlow);
        bytesShown = slot.bytesRead;
    }

    private void addToReport(BatchPipeline.Slot slot) {
        if (report == null || reportFailure != null) {
            return;
        }
        try {
            report.add(slot.events, slot.flow);
        } catch (RuntimeException e) {
            reportFailure = e;
        }
    }

    /** Number of events of a labelled batch that have flow. */
    static int countWithFlow(EventBatch batch, FlowOutput flow) {
        int count = 0;
        for (int i = 0; i < batch.size(); i++) {
            count += flow.segment[i] != 0 ? 1 : 0;
        }
        return count;
    }

    /** Why the recording could not be read to its end; null if it was. */
    EventSourceException damage() {
        return damage;
    }

    /** Why the report did not take all events; null if it did, or there is none. */
    Exception reportFailure() {
        return reportFailure;
    }

    /** All segments: those that ended, then those that are alive. */
    List<Segment> segments() {
        List<Segment> all = new ArrayList<>(ended);
        all.addAll(living());
        return all;
    }

    /** Number of events with flow. */
    long eventsWithFlow() {
        return eventsWithFlow;
    }

    /** The likely reason why most events have no flow; empty if most have flow. */
    String likelyReason() {
        return withoutFlow.likelyReason();
    }

    /**
     * The time that each step took.
     *
     * @param wallNs time of the whole run until now, ns
     * @param openNs time for opening the recording, ns
     */
    RunSummary.Seconds seconds(long wallNs, long openNs) {
        return new RunSummary.Seconds(wallNs / 1e9, (openNs + decodeNs) / 1e9, (engineNs + lookAheadNs) / 1e9,
            outputNs / 1e9);
    }
}
