package io.github.sofas.report;

import static j2html.TagCreator.div;
import static j2html.TagCreator.figcaption;
import static j2html.TagCreator.figure;
import static j2html.TagCreator.h2;
import static j2html.TagCreator.img;
import static j2html.TagCreator.p;

import io.github.sofas.evaluate.Sharpness;
import io.github.sofas.evaluate.WindowPictures;
import io.github.sofas.event.SensorSize;
import j2html.tags.DomContent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;

/**
 * The part of the page that shows how much sharper the flow makes the picture: in words, and by pictures before and
 * after.
 */
final class SharpnessPart {
    /** Least width of a picture, px. */
    private static final int WIDTH = 480;
    /** Share of the brightest pixels, which may become entirely white. All darker pixels keep their differences. */
    private static final double DAZZLING_SHARE = 0.002;

    private SharpnessPart() {
    }

    /** The elements of this part; none if there is no event. */
    static List<DomContent> of(SensorSize sensor, Sharpness sharpness, WindowPictures fullest, long firstUs)
            throws IOException {
        if (fullest == null) {
            return List.of();
        }
        double fromS = (fullest.window().fromUs() - firstUs) * 1e-6;
        double untilS = (fullest.window().untilUs() - firstUs) * 1e-6;
        float white = white(fullest.before(), fullest.after());
        String moment = String.format(Locale.ROOT, "%.3f to %.3f s", fromS, untilS);
        return List.of(h2("How sharp it is"),
            p(words("This flow", sharpness.sharpness())),
            div(
                picture(sensor, fullest.before(), white, "before", "Before: the events of " + moment
                    + ", where they were."),
                picture(sensor, fullest.after(), white, "after", "After: each moved along its flow to the middle of "
                    + "that time. " + words("Here it", fullest.window().sharpness())))
                .withClass("grid"),
            p("Right flow puts the events of an edge on one another. Sharpness is the variance of the picture of the "
                + "moved events over that of the events as they are, both blurred by a pixel; events without flow "
                + "stay. The pictures are those of the window, of " + sharpness.windows().size()
                + ", in which most events have flow."));
    }

    private static String words(String subject, double sharpness) {
        long percent = Math.round(100 * Math.abs(sharpness - 1));
        if (percent == 0) {
            return subject + " makes the picture neither sharper nor less sharp.";
        }
        return subject + (sharpness > 1 ? " makes the picture " + percent + " % sharper."
            : " blurs the picture: " + percent + " % less sharp.");
    }

    private static float white(float[] before, float[] after) {
        float[] all = Arrays.copyOf(before, before.length + after.length);
        System.arraycopy(after, 0, all, before.length, after.length);
        Arrays.sort(all);
        return Math.max(1, all[(int) ((1 - DAZZLING_SHARE) * (all.length - 1))]);
    }

    private static DomContent picture(SensorSize sensor, float[] counts, float white, String alt, String caption)
            throws IOException {
        int scale = (WIDTH + sensor.width() - 1) / sensor.width();
        BufferedImage image = new BufferedImage(scale * sensor.width(), scale * sensor.height(),
            BufferedImage.TYPE_BYTE_GRAY);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                float count = counts[y / scale * sensor.width() + x / scale];
                // The square root keeps a single event visible beside many.
                int grey = (int) Math.round(255 * Math.sqrt(Math.min(1, count / white)));
                image.getRaster().setSample(x, y, 0, grey);
            }
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return figure(img().withAlt("the events " + alt).withSrc("data:image/png;base64,"
            + Base64.getEncoder().encodeToString(png.toByteArray())), figcaption(caption));
    }
}
