package io.github.sofas.evaluate;

/**
 * Sharpness of the pictures of one window. {@link Sharpness} defines the pictures and their variances.
 *
 * @param fromUs time of the window's first event, in µs
 * @param untilUs time of the window's last event, in µs
 * @param events number of events in the window
 * @param eventsWithFlow number of events that have flow
 * @param variance variance of the picture of the events as they are
 * @param movedVariance variance of the picture of the events moved along their flow
 * @param translatedVariance variance of the picture of the events moved along the best single translation, at least
 *     {@code variance}
 * @param translationVxPxPerS velocity of the best single translation, to the right, in px/s
 * @param translationVyPxPerS velocity of the best single translation, downwards, in px/s
 */
public record SharpnessWindow(long fromUs, long untilUs, long events, long eventsWithFlow, double variance,
                              double movedVariance, double translatedVariance, double translationVxPxPerS,
                              double translationVyPxPerS) {
    /** {@return the sharpness of the flow; 1 if the picture of the events as they are has no variance} */
    public double sharpness() {
        return Sharpness.ratio(movedVariance, variance);
    }

    /** {@return the sharpness of the best single translation, at least 1} */
    public double translationSharpness() {
        return Sharpness.ratio(translatedVariance, variance);
    }

    /** {@return the share of the events that have flow} */
    public double shareWithFlow() {
        return FlowFigures.share(eventsWithFlow, events);
    }
}
