package io.github.sofas.evaluate;

/**
 * How sharp one window's picture is. The variances are those of {@link Sharpness}.
 *
 * @param fromUs time of its first event in µs
 * @param untilUs time of its last event in µs
 * @param events how many it has
 * @param eventsWithFlow how many of them have flow
 * @param variance variance of the picture of the events as they are
 * @param movedVariance variance of the picture of the events moved along their flow
 * @param translatedVariance variance of the picture of the events moved along the best single translation, at least
 *     {@code variance}
 * @param translationVxPxPerS the best single translation, to the right, in px/s
 * @param translationVyPxPerS the same downwards
 */
public record SharpnessWindow(long fromUs, long untilUs, long events, long eventsWithFlow, double variance,
                              double movedVariance, double translatedVariance, double translationVxPxPerS,
                              double translationVyPxPerS) {
    /** {@return the sharpness of the flow; 1 where the picture as it is has no variance} */
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
