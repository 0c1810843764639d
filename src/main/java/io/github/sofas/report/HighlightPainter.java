package io.github.sofas.report;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.FlowCsvReader;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.render.Mp4Film;
import io.github.sofas.render.PictureSheet;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import javax.imageio.ImageIO;

/**
 * Paints the clip and the busiest moments of a recording. These are known only after all events were labelled, so the
 * labelled events are read a second time.
 */
final class HighlightPainter {
    private static final int BATCH = 4096;

    private final PictureSheet sheet;
    private final Highlights highlights;
    private final long firstUs;
    /** Steps still to be painted, each with its busy moment; null for a step that belongs to the clip only. */
    private final TreeMap<Long, Highlights.Moment> steps = new TreeMap<>();
    private final List<Thumbnail> thumbnails = new ArrayList<>();

    /**
     * A picture of a busy moment.
     *
     * @param moment the moment
     * @param png the picture
     */
    record Thumbnail(Highlights.Moment moment, byte[] png) {
    }

    /** Prepares for a recording whose first event has a given time. The highlights must be finished. */
    HighlightPainter(PictureSheet sheet, Highlights highlights, long firstUs) {
        this.sheet = sheet;
        this.highlights = highlights;
        this.firstUs = firstUs;
        for (long step = highlights.clipFirst(); step < highlights.clipEnd(); step++) {
            steps.put(step, null);
        }
        highlights.moments().forEach(moment -> steps.put(moment.step(), moment));
    }

    /** Reads the events as far as needed, writes the clip and returns the pictures of the busy moments. */
    List<Thumbnail> paint(FlowCsvReader events, Path clip) throws IOException, EventSourceException {
        EventBatch batch = new EventBatch(BATCH);
        FlowOutput labels = new FlowOutput(BATCH);
        try (Mp4Film film = new Mp4Film(clip, Highlights.FPS)) {
            while (!steps.isEmpty() && events.next(batch, labels)) {
                int from = 0;
                for (int i = 0; i < batch.size(); i++) {
                    if (isDue(batch.timeUs[i])) {
                        sheet.add(batch, labels, from, i);
                        from = i;
                        paintUntil(batch.timeUs[i], film);
                    }
                }
                sheet.add(batch, labels, from, batch.size());
            }
            paintUntil(Long.MAX_VALUE, film);
        }
        return thumbnails;
    }

    /** The {@link PictureSheet#legend} of both panels, as PNG. */
    List<byte[]> legends() throws IOException {
        List<byte[]> legends = new ArrayList<>();
        for (int k = 0; k < 2; k++) {
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageIO.write(sheet.legend(k), "png", png);
            legends.add(png.toByteArray());
        }
        return legends;
    }

    private boolean isDue(long timeUs) {
        return !steps.isEmpty() && timeUs - firstUs >= endUs(steps.firstKey());
    }

    private static long endUs(long step) {
        return (step + 1) * Highlights.STEP_US;
    }

    private void paintUntil(long timeUs, Mp4Film film) throws IOException {
        while (isDue(timeUs)) {
            long step = steps.firstKey();
            Highlights.Moment moment = steps.remove(step);
            BufferedImage picture = sheet.paint(firstUs + endUs(step), endUs(step), null);
            if (step >= highlights.clipFirst() && step < highlights.clipEnd()) {
                film.add(picture);
            }
            if (moment != null) {
                ByteArrayOutputStream png = new ByteArrayOutputStream();
                ImageIO.write(picture, "png", png);
                thumbnails.add(new Thumbnail(moment, png.toByteArray()));
            }
        }
    }
}
