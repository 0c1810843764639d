package io.github.sofas.report;

import io.github.sofas.evaluate.Sharpness;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.FlowCsvReader;
import io.github.sofas.export.RunSummary;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.render.Panel;
import io.github.sofas.render.PictureOptions;
import io.github.sofas.render.PictureSheet;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Collects figures about the labelled events of a run, and writes a page about the run.
 *
 * <p>Which moments are worth a picture is known only at the end. The events of the pictures are then read again, from
 * the flow file that the run wrote.
 */
public final class ReportCollector {
    static final int DIRECTIONS = 36;
    /** Number of ended segments whose curves are kept: those with the most events. */
    private static final int MOST_CURVES = 256;

    private final SensorSize sensor;
    private final TimeBins bins = new TimeBins();
    private final Highlights highlights = new Highlights();
    private final Map<Integer, SegmentCurve> curves = new HashMap<>();
    private final long[] directions = new long[DIRECTIONS];
    private final Sharpness.Gatherer sharpness;

    private boolean begun;
    private long firstUs;

    /**
     * Makes a collector without events.
     *
     * @param sensor size of the pixel array
     */
    public ReportCollector(SensorSize sensor) {
        this.sensor = sensor;
        sharpness = Sharpness.Gatherer.withoutTranslation(sensor);
    }

    /**
     * Takes a batch.
     *
     * @param batch the events
     * @param flow labels of the same events
     */
    public void add(EventBatch batch, FlowOutput flow) {
        if (!begun && batch.size() > 0) {
            begun = true;
            firstUs = batch.timeUs[0];
        }
        sharpness.add(batch, flow);
        for (int i = 0; i < batch.size(); i++) {
            long sinceUs = batch.timeUs[i] - firstUs;
            boolean hasFlow = flow.segment[i] != 0;
            highlights.add(sinceUs, hasFlow);
            int place = bins.place(sinceUs);
            bins.add(place, hasFlow);
            if (hasFlow) {
                float vx = flow.vxPxPerS[i];
                float vy = flow.vyPxPerS[i];
                curve(flow.segment[i], place).add(place, bins.widthUs(), vx, vy);
                int sector = (int) Math.round(Math.atan2(-vy, vx) / (2 * Math.PI) * DIRECTIONS);
                directions[Math.floorMod(sector, DIRECTIONS)]++;
            }
        }
    }

    private SegmentCurve curve(int id, int place) {
        SegmentCurve curve = curves.get(id);
        if (curve == null) {
            if (curves.size() >= 2 * MOST_CURVES) {
                forgetLeast(place);
            }
            curve = new SegmentCurve(id, bins.widthUs(), place);
            curves.put(id, curve);
        }
        return curve;
    }

    private void forgetLeast(int place) {
        List<SegmentCurve> ended = new ArrayList<>();
        for (SegmentCurve curve : curves.values()) {
            curve.widenTo(bins.widthUs());
            if (curve.first() + curve.used() < place) {
                ended.add(curve);
            }
        }
        ended.sort(Comparator.comparingLong(SegmentCurve::events).reversed());
        for (int k = MOST_CURVES; k < ended.size(); k++) {
            curves.remove(ended.get(k).id);
        }
    }

    /** Curves of the segments, those with the most events first. */
    List<SegmentCurve> curves() {
        List<SegmentCurve> sorted = new ArrayList<>(curves.values());
        sorted.forEach(curve -> curve.widenTo(bins.widthUs()));
        sorted.sort(Comparator.comparingLong(SegmentCurve::events).reversed());
        return sorted;
    }

    /**
     * Writes the page. No events may be added afterwards.
     *
     * @param out receives the page; left open
     * @param summary summary of the same run
     * @param command the command that was typed, for users to repeat
     * @param flow file with the same events and their labels, written by {@link io.github.sofas.export.FlowCsvWriter}
     * @throws IOException if the page cannot be written, or if the file cannot be read
     */
    public void write(OutputStream out, RunSummary summary, String command, Path flow) throws IOException {
        highlights.finish();
        List<SegmentCurve> longest = curves();
        PictureSheet sheet = new PictureSheet(sensor,
            PictureOptions.defaults().withPanels(List.of(Panel.FLOW, Panel.SEGMENTS)));
        for (int k = 0; k < Math.min(ReportPage.CURVES, longest.size()); k++) {
            sheet.colour(longest.get(k).id, k);
        }
        Path clip = Files.createTempFile("sofas-clip", ".mp4");
        try {
            List<HighlightPainter.Thumbnail> thumbnails = List.of();
            List<byte[]> legends = List.of();
            if (begun) {
                try (FlowCsvReader events = FlowCsvReader.open(flow)) {
                    HighlightPainter painter = new HighlightPainter(sheet, highlights, firstUs);
                    thumbnails = painter.paint(events, clip);
                    legends = painter.legends();
                }
            }
            Sharpness measured = sharpness.sharpness();
            new ReportPage(summary, command, bins, longest, directions, highlights, thumbnails, legends,
                SharpnessPart.of(sensor, measured, sharpness.fullest(), firstUs), clip).write(out);
        } catch (EventSourceException e) {
            throw new IOException(e.getMessage(), e);
        } finally {
            Files.delete(clip);
        }
    }
}
