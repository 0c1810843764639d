package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;

/**
 * Where a structure is and was: its contour, on which the events of late lie, and what is remembered of it. Both travel
 * along its motion; for how long they hold events follows from its lifetime and speed, and from the noise.
 *
 * <p>Ours: the paper's track plane has the contour only.
 */
final class Outline {
    /** Longest time for which the contour is remembered: what stands still would haunt its place. */
    private static final long MAX_MEMORY_US = 2_000_000;
    /** Part of the lifetime for which the contour holds events at least. */
    private static final int HELD_PART = 8;
    /** Speed in px/s that what stands is taken to have. */
    private static final double LEAST_SPEED = 1e-3;

    private final Contour contour;
    private final ContourMemory memory;
    private double memoryPx;
    /** How many noise events a pixel gave of either polarity last, per µs. */
    private double noisePerUs;

    /**
     * Makes one that holds nothing.
     *
     * @param memoryPx travel for which the contour is remembered
     */
    Outline(SensorSize sensor, Contour.Spare spare, double memoryPx) {
        contour = new Contour(sensor, spare);
        memory = new ContourMemory(sensor.width(), sensor.height());
        this.memoryPx = memoryPx;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return Contour.bytes(sensor) + ContourMemory.bytes(sensor);
    }

    /** Remembers the contour for so many px of travel from then on. */
    void setMemoryPx(double px) {
        memoryPx = px;
    }

    /** Begins without events, along a motion. */
    void start(Motion along, double noise) {
        noisePerUs = noise;
        contour.start(along);
        memory.start(along);
    }

    /** Where events fell of late. */
    Contour contour() {
        return contour;
    }

    /** What it was seen as before. */
    ContourMemory memory() {
        return memory;
    }

    /** How many noise events a pixel gave of either polarity last, per µs. */
    double noisePerUs() {
        return noisePerUs;
    }

    /** Time in which the structure travels the pixels that it remembers its contour for. */
    long memoryUs(Motion motion) {
        return (long) Math.min(MAX_MEMORY_US, memoryPx / Math.max(motion.speed(contour.radius()), LEAST_SPEED) * 1e6);
    }

    /** Time for which the contour holds events: the lifetime, less where noise would fill it. */
    private long heldUs(long lifetimeUs) {
        return Math.min(lifetimeUs, Math.max(lifetimeUs / HELD_PART, Noise.mostUs(noisePerUs)));
    }

    /**
     * Notes an event of the past.
     *
     * @param ageUs how long ago it was
     * @return the hash of its tile
     */
    int see(int x, int y, long timeUs, int polarity, long ageUs, long lifetimeUs) {
        contour.add(x, y, timeUs, polarity, ageUs, heldUs(lifetimeUs));
        return memory.see(x, y, timeUs);
    }

    /**
     * Notes an event of now; unless it is remembered, it is the one whose support was asked for last.
     *
     * @return the hash of its tile
     */
    int take(int x, int y, long timeUs, int polarity, Claim claim, long lifetimeUs) {
        if (claim == Claim.REMEMBERED) {
            contour.add(x, y, timeUs, polarity, 0, heldUs(lifetimeUs));
            return memory.tile(x, y, timeUs);
        }
        contour.addLast(polarity);
        return memory.see(x, y, timeUs);
    }

    /**
     * Lets go what is older than events are held for.
     *
     * @param noise how many noise events a pixel gives of either polarity, per µs
     * @param either whether events of either polarity are expected where those of one were seen
     */
    void pass(long nowUs, double noise, boolean either, long lifetimeUs) {
        noisePerUs = noise;
        contour.expectEither(either);
        contour.fade(nowUs, heldUs(lifetimeUs));
    }

    /** Lets the contour follow a motion that is known a little better, from its reference on. */
    void follow(Motion motion, long lifetimeUs) {
        contour.fade(motion.referenceUs, heldUs(lifetimeUs));
        contour.follow(motion);
    }

    /** Draws the contour anew along a motion that was known badly. */
    void draw(LiveEvents live, Motion motion, long lifetimeUs) {
        contour.draw(live, motion, heldUs(lifetimeUs));
    }

    /** Takes threshold, size and the motion's centre from the contour as it lies now, and lets the memory follow. */
    void measure(LiveEvents live, Motion motion, long lifetimeUs) {
        contour.measure(live, motion, Noise.support(noisePerUs, heldUs(lifetimeUs)));
        motion.moveCentre(contour.centreX(), contour.centreY());
        remember(motion);
    }

    /** Lets the memory follow a motion to its reference. */
    void remember(Motion motion) {
        memory.follow(motion, memoryUs(motion));
    }

    /** Remembers the places of events. */
    void remember(LiveEvents events) {
        for (int k = 0; k < events.size(); k++) {
            int i = events.index(k);
            memory.see(events.x[i], events.y[i], events.timeUs[i]);
        }
    }
}
