package io.github.sofas.evaluate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.ArrayList;
import java.util.List;

/**
 * How much sharper the flow makes the picture of a recording. Measures accuracy without truth, by the flow warp loss of
 * Stoffregen et al., "Reducing the sim-to-real gap for event cameras", ECCV 2020.
 *
 * <p>Time is cut into windows without gaps. A window ends with the event that completes {@value #EVENTS_PER_PX} events
 * per pixel of the sensor, but not before {@value #SHORTEST_US} µs have passed. At the latest, a window ends before the
 * event that would extend it to {@value #LONGEST_US} µs; the last window ends with the recording.
 *
 * <p>All events of a window are drawn in three pictures, each of which counts the events of either polarity at the
 * nearest pixel of the sensor:
 * <ul>
 * <li>the events where they occurred;
 * <li>each event moved along its own flow to the middle between the window's first and last event, where events without
 *     flow stay in place and events that leave the sensor are not drawn;
 * <li>all events moved along one velocity, the best that a search finds.
 * </ul>
 * Each picture is blurred with a Gaussian of 1 px, because edges that slide along themselves would look sharper
 * otherwise. Its variance is then taken over all pixels of the sensor.
 * <pre>
 *   sharpness              variance of the events moved along their flow / variance of the events as they are
 *   ... of a translation   variance of the events moved along the best single velocity / the same
 *   gain                   (sharpness - 1) / (sharpness of the best single translation - 1)
 * </pre>
 * Figures of the whole recording use the same formulas with the variances summed over the windows. A busy window thus
 * weighs more, and a window with a few noise events next to nothing. A gain of 1 is as good as a single velocity for
 * the whole picture, chosen with knowledge of the window's future. With a gain below 0, the flow blurs the picture.
 *
 * @param windows all windows, in order
 */
public record Sharpness(List<SharpnessWindow> windows) {
    /** Number of events per pixel of the sensor that fills a window. */
    public static final double EVENTS_PER_PX = 0.2;
    /** Shortest duration of a window that events fill, in µs. */
    public static final long SHORTEST_US = 20_000;
    /** Upper bound on the duration of a window, exclusive, in µs. */
    public static final long LONGEST_US = 300_000;
    /** Least amount by which single translations must sharpen the picture for the gain of a flow to be defined. */
    public static final double LEAST_TRANSLATION_GAIN = 0.001;

    /**
     * Makes the list immutable.
     *
     * @param windows all windows, in order
     */
    public Sharpness {
        windows = List.copyOf(windows);
    }

    /** {@return the sharpness of the flow; 1 if there is no variance} */
    public double sharpness() {
        return ratio(movedVariance(), variance());
    }

    /** {@return the sharpness of the best single translation of each window, at least 1} */
    public double translationSharpness() {
        return ratio(translatedVariance(), variance());
    }

    /** {@return whether the best single translations sharpen the picture enough for a gain} */
    public boolean hasGain() {
        return hasGain(translationSharpness());
    }

    /** {@return the gain of the flow over the best single translation; meaningful only if {@link #hasGain}} */
    public double gain() {
        return gain(sharpness(), translationSharpness());
    }

    /** {@return the number of events} */
    public long events() {
        return windows.stream().mapToLong(SharpnessWindow::events).sum();
    }

    /** {@return the number of events that have flow} */
    public long eventsWithFlow() {
        return windows.stream().mapToLong(SharpnessWindow::eventsWithFlow).sum();
    }

    /** {@return the share of the events that have flow} */
    public double shareWithFlow() {
        return FlowFigures.share(eventsWithFlow(), events());
    }

    private double variance() {
        return windows.stream().mapToDouble(SharpnessWindow::variance).sum();
    }

    private double movedVariance() {
        return windows.stream().mapToDouble(SharpnessWindow::movedVariance).sum();
    }

    private double translatedVariance() {
        return windows.stream().mapToDouble(SharpnessWindow::translatedVariance).sum();
    }

    static double ratio(double variance, double of) {
        return of == 0 ? 1 : variance / of;
    }

    static boolean hasGain(double translationSharpness) {
        return translationSharpness - 1 >= LEAST_TRANSLATION_GAIN;
    }

    static double gain(double sharpness, double translationSharpness) {
        return hasGain(translationSharpness) ? (sharpness - 1) / (translationSharpness - 1) : 0;
    }

    /** Measures a recording, window by window, while it is labelled. Holds the events of one window in memory. */
    public static final class Gatherer {
        private final int eventsOfFullWindow;
        private final EventPicture picture;
        private final SingleTranslation translation;
        private final KnownTranslations known;
        private final String recording;
        private final boolean searches;
        private final MovedEvents window = new MovedEvents();
        private final List<SharpnessWindow> windows = new ArrayList<>();
        private WindowPictures fullest;

        /**
         * Makes one for a sensor.
         *
         * @param sensor size of the pixel array
         */
        public Gatherer(SensorSize sensor) {
            this(sensor, new KnownTranslations(), "");
        }

        /**
         * Makes one that looks up the best single translations, and searches and adds those that are not known.
         *
         * @param sensor size of the pixel array
         * @param known translations that were found before; new ones are added
         * @param recording name of the recording among the known translations
         */
        public Gatherer(SensorSize sensor, KnownTranslations known, String recording) {
            this(sensor, known, recording, true);
        }

        private Gatherer(SensorSize sensor, KnownTranslations known, String recording, boolean searches) {
            this.searches = searches;
            this.known = known;
            this.recording = recording;
            eventsOfFullWindow = (int) Math.ceil(EVENTS_PER_PX * sensor.width() * sensor.height());
            picture = new EventPicture(sensor);
            translation = new SingleTranslation(sensor);
        }

        /**
         * Makes one without the search for the best single translation, which takes most of the time. Rest stands in
         * for the translation of each window.
         *
         * @param sensor size of the pixel array
         * @return an empty gatherer
         */
        public static Gatherer withoutTranslation(SensorSize sensor) {
            return new Gatherer(sensor, null, "", false);
        }

        /**
         * Adds a batch and its labels. The windows do not depend on how the events are cut into batches.
         *
         * @param batch the events
         * @param flow labels of the same events
         */
        public void add(EventBatch batch, FlowOutput flow) {
            for (int i = 0; i < batch.size(); i++) {
                if (window.size() > 0 && batch.timeUs[i] - window.firstUs() >= LONGEST_US) {
                    endWindow();
                }
                window.add(batch, flow, i);
                if (window.size() >= eventsOfFullWindow && window.lastUs() - window.firstUs() >= SHORTEST_US) {
                    endWindow();
                }
            }
        }

        private void endWindow() {
            window.drawAsTheyAre(picture);
            double variance = picture.variance();
            boolean fuller = fullest == null || window.withFlow() > fullest.window().eventsWithFlow();
            float[] before = fuller ? picture.counts().clone() : null;
            window.drawMoved(picture);
            double movedVariance = picture.variance();
            SharpnessWindow ended = new SharpnessWindow(window.firstUs(), window.lastUs(), window.size(),
                window.withFlow(), variance, movedVariance, variance, 0, 0);
            if (fuller) {
                fullest = new WindowPictures(ended, before, picture.counts().clone());
            }
            if (searches) {
                known.take(recording, window, translation);
                ended = new SharpnessWindow(window.firstUs(), window.lastUs(), window.size(), window.withFlow(),
                    variance, movedVariance, translation.variance(), translation.vxPxPerS(), translation.vyPxPerS());
            }
            windows.add(ended);
            window.clear();
        }

        /**
         * Ends the last window and returns the figures. No events may be added afterwards.
         *
         * @return the figures
         */
        public Sharpness sharpness() {
            if (window.size() > 0) {
                endWindow();
            }
            return new Sharpness(windows);
        }

        /**
         * Returns the pictures of the window with the most events that have flow.
         *
         * @return the pictures, of the first such window; null before the first window has ended
         */
        public WindowPictures fullest() {
            return fullest;
        }
    }
}
