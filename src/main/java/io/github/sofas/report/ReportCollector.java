package io.github.sofas.report;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.export.RunSummary;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.render.Mp4Film;
import io.github.sofas.render.Panel;
import io.github.sofas.render.PictureOptions;
import io.github.sofas.render.PictureSheet;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;

/** Sees the labelled events of a run, and writes a page about them. */
public final class ReportCollector implements Closeable {
    static final int DIRECTIONS = 36;
    private static final int FPS = 30;
    private static final long STEP_US = 1_000_000 / FPS;
    private static final int CLIP_PICTURES = 10 * FPS;
    private static final int THUMBNAILS = 6;
    private static final long APART_US = 300_000;

    private final PictureSheet sheet;
    private final Path clipFile;
    private final Mp4Film clip;
    private int clipPictures;

    private final TimeBins bins = new TimeBins();
    private final Map<Integer, SegmentCurve> curves = new HashMap<>();
    private final long[] directions = new long[DIRECTIONS];
    private final List<Thumbnail> thumbnails = new ArrayList<>();

    private boolean begun;
    private long firstUs;
    private long pictureUs;
    private long sincePicture;

    /** A picture of a busy moment. */
    record Thumbnail(long sinceFirstUs, long events, byte[] png) {
    }

    /**
     * Begins.
     *
     * @throws IOException where no temporary file can be made, which holds the clip until the page is written
     */
    public ReportCollector(SensorSize sensor) throws IOException {
        sheet = new PictureSheet(sensor, PictureOptions.defaults().withPanels(List.of(Panel.FLOW, Panel.SEGMENTS)));
        clipFile = Files.createTempFile("sofas-clip", ".mp4");
        clip = new Mp4Film(clipFile, FPS);
    }

    /**
     * Takes a batch.
     *
     * @throws IOException where a picture cannot be written
     */
    public void add(EventBatch batch, FlowOutput flow) throws IOException {
        if (!begun && batch.size() > 0) {
            begun = true;
            firstUs = batch.timeUs[0];
            pictureUs = STEP_US;
        }
        int from = 0;
        for (int i = 0; i < batch.size(); i++) {
            long sinceUs = batch.timeUs[i] - firstUs;
            if (sinceUs >= pictureUs) {
                sheet.add(batch, flow, from, i);
                from = i;
                shoot(sinceUs);
            }
            sincePicture++;
            boolean hasFlow = flow.segment[i] != 0;
            int place = bins.place(sinceUs);
            bins.add(place, hasFlow);
            if (hasFlow) {
                float vx = flow.vxPxPerS[i];
                float vy = flow.vyPxPerS[i];
                curves.computeIfAbsent(flow.segment[i], id -> new SegmentCurve(id, bins.widthUs(), place))
                    .add(place, bins.widthUs(), vx, vy);
                int sector = (int) Math.round(Math.atan2(-vy, vx) / (2 * Math.PI) * DIRECTIONS);
                directions[Math.floorMod(sector, DIRECTIONS)]++;
            }
        }
        sheet.add(batch, flow, from, batch.size());
    }

    /** Takes the pictures that are due before a time; in a pause without events the clip stands still. */
    private void shoot(long sinceUs) throws IOException {
        while (clipPictures < CLIP_PICTURES && sinceUs >= pictureUs) {
            clip.add(sheet.paint(firstUs + pictureUs, pictureUs, null));
            clipPictures++;
            keepIfBusy(pictureUs);
            sincePicture = 0;
            pictureUs += STEP_US;
        }
        if (sinceUs >= pictureUs) {
            keepIfBusy(pictureUs);
            sincePicture = 0;
            pictureUs += (sinceUs - pictureUs) / STEP_US * STEP_US + STEP_US;
        }
    }

    /** Keeps a picture of the moment where it is among the busiest; of close ones only the busiest. */
    private void keepIfBusy(long atUs) throws IOException {
        Thumbnail close = null;
        Thumbnail least = null;
        for (Thumbnail each : thumbnails) {
            if (Math.abs(each.sinceFirstUs - atUs) < APART_US) {
                close = each;
            }
            if (least == null || each.events < least.events) {
                least = each;
            }
        }
        Thumbnail replaced = close != null ? close : thumbnails.size() < THUMBNAILS ? null : least;
        if (sincePicture == 0 || replaced != null && replaced.events >= sincePicture) {
            return;
        }
        thumbnails.remove(replaced);
        thumbnails.add(new Thumbnail(atUs, sincePicture, png(sheet.paint(firstUs + atUs, atUs, null))));
    }

    private static byte[] png(BufferedImage picture) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", bytes);
        return bytes.toByteArray();
    }

    /**
     * Writes the page; nothing can be added then.
     *
     * @param out left open
     * @param summary of the same run
     * @param command what was typed, to be typed again
     * @throws IOException where it cannot be written
     */
    public void write(OutputStream out, RunSummary summary, String command) throws IOException {
        clip.close();
        List<SegmentCurve> longest = new ArrayList<>(curves.values());
        longest.forEach(curve -> curve.widenTo(bins.widthUs()));
        longest.sort(Comparator.comparingLong(SegmentCurve::events).reversed());
        thumbnails.sort(Comparator.comparingLong(Thumbnail::sinceFirstUs));
        byte[] film = clipPictures == 0 ? new byte[0] : Files.readAllBytes(clipFile);
        out.write(new ReportPage(summary, command, bins, longest, directions, thumbnails, film).html()
            .getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() throws IOException {
        clip.close();
        Files.deleteIfExists(clipFile);
    }
}
