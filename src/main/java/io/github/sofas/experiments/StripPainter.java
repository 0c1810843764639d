package io.github.sofas.experiments;

import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.GroundTruth;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Sofas;
import io.github.sofas.render.FlowColours;
import io.github.sofas.render.Panel;
import io.github.sofas.render.PictureOptions;
import io.github.sofas.render.PictureSheet;
import io.github.sofas.render.Theme;
import io.github.sofas.simulate.SimulatedRecording;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Paints the pictures of a {@link Strip}: labels a film by a method, and paints the labels at four moments. */
final class StripPainter {
    private static final long EXPOSURE_US = 30_000;
    private static final int SCALE = 2;

    private final Map<Theme, PictureSheet> sheets = new EnumMap<>(Theme.class);
    private final SimulatedRecording recording;
    private final double fullPxPerS;
    private final List<Strip.Moment> moments = new ArrayList<>();
    private Picture withLegends;

    private StripPainter(SimulatedRecording recording) {
        this.recording = recording;
        fullPxPerS = fullPxPerS(recording);
        for (Theme theme : Theme.values()) {
            sheets.put(theme, new PictureSheet(recording.sensor(), new PictureOptions(Strip.PANELS, theme,
                FlowColours.Wheel.SAFE, SCALE, EXPOSURE_US, 0, fullPxPerS, null)));
        }
    }

    /** The least of 1, 2, 5, 10 and so on px/s that nine tenths of the object events do not exceed. */
    private static double fullPxPerS(SimulatedRecording recording) {
        double[] speeds = IntStream.range(0, recording.size())
            .filter(i -> recording.object[i] != GroundTruth.NOISE)
            .mapToDouble(i -> Math.hypot(recording.vxPxPerS[i], recording.vyPxPerS[i])).sorted().toArray();
        double most = speeds.length == 0 ? 1 : speeds[(int) (0.9 * (speeds.length - 1))];
        double step = 1;
        for (int k = 0; step < most; k++) {
            step *= k % 3 == 1 ? 2.5 : 2;
        }
        return step;
    }

    /** Labels a film by a method up to the last moment, and paints the moments. */
    static Strip strip(SimulatedRecording recording, EventLabeller method) {
        return strip(recording, method, new FlowEstimate());
    }

    /**
     * Paints a strip in the same way, and keeps the labels, too.
     *
     * @param estimate receives the labels of all events before the last moment
     */
    static Strip strip(SimulatedRecording recording, EventLabeller method, FlowEstimate estimate) {
        StripPainter painter = new StripPainter(recording);
        for (long timeUs : timesUs(recording.durationUs())) {
            int before = 0;
            while (before < recording.size() && recording.timeUs[before] < timeUs) {
                before++;
            }
            estimate.label(recording, method, before);
            painter.take(timeUs, estimate, method);
        }
        return painter.strip();
    }

    /** The times of the moments of a film: at 0.2, 0.4, 0.6 and 0.8 of its duration. */
    private static List<Long> timesUs(long durationUs) {
        return List.of(durationUs / 5, 2 * durationUs / 5, 3 * durationUs / 5, 4 * durationUs / 5);
    }

    /**
     * Paints the pictures of a method that has just labelled all events up to a time.
     *
     * @param estimate the labels of these events
     */
    private void take(long timeUs, FlowEstimate estimate, EventLabeller method) {
        int until = estimate.size();
        int from = until;
        while (from > 0 && recording.timeUs[from - 1] >= timeUs - EXPOSURE_US) {
            from--;
        }
        int n = until - from;
        EventBatch batch = new EventBatch(Math.max(1, n));
        FlowOutput flow = new FlowOutput(Math.max(1, n));
        for (int i = 0; i < n; i++) {
            batch.add(recording.timeUs[from + i], recording.x[from + i], recording.y[from + i],
                recording.polarity[from + i]);
            flow.vxPxPerS[i] = estimate.vxPxPerS(from + i);
            flow.vyPxPerS[i] = estimate.vyPxPerS(from + i);
            flow.segment[i] = estimate.segment(from + i);
        }
        Map<Theme, BufferedImage> painted = new EnumMap<>(Theme.class);
        sheets.forEach((theme, sheet) -> {
            sheet.add(batch, flow, 0, n);
            painted.put(theme, sheet.paint(timeUs, timeUs, method instanceof Sofas ? (Sofas) method : null));
        });
        Map<Panel, Picture> pictures = new EnumMap<>(Panel.class);
        for (int k = 0; k < Strip.PANELS.size(); k++) {
            Panel panel = Strip.PANELS.get(k);
            pictures.put(panel, Charts.of(sheets.get(Theme.LIGHT).panel(k), sheets.get(Theme.DARK).panel(k),
                panel + " at " + timeUs / 1000 + " ms"));
        }
        moments.add(new Strip.Moment(timeUs, pictures));
        withLegends = Charts.of(painted.get(Theme.LIGHT), painted.get(Theme.DARK), "flow, segments and contours");
    }

    /** The pictures painted so far. */
    private Strip strip() {
        return new Strip(fullPxPerS, List.copyOf(moments), withLegends);
    }
}
