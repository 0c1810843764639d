package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;

/**
 * Where a structure is and was: its contour, on which its recent events lie, and a memory of where the contour has
 * been. Both travel along the motion of the structure. How long they hold events follows from the lifetime, the speed
 * and the noise.
 *
 * <p>Ours: the paper's track plane has only the contour.
 */
final class Outline {
    /**
     * Longest time for which the contour is remembered: a structure that stands still would haunt its place otherwise.
     */
    private static final long MAX_MEMORY_US = 2_000_000;
    /** Part of the lifetime for which the contour holds events at the least. */
    private static final int HELD_PART = 8;
    /** Speed in px/s that a structure at rest is taken to have. */
    private static final double LEAST_SPEED = 1e-3;

    private final Contour contour;
    private final ContourMemory memory;
    private double memoryPx;
    /** Latest rate of noise events per pixel and per µs, of each polarity. */
    private double noisePerUs;

    /**
     * Makes an outline that holds nothing.
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

    /** Sets the travel, in px, for which the contour is remembered from now on. */
    void setMemoryPx(double px) {
        memoryPx = px;
    }

    /** Begins without events, along a motion. */
    void start(Motion along, double noise) {
        noisePerUs = noise;
        contour.start(along);
        memory.start(along);
    }

    /** Where events fell recently. */
    Contour contour() {
        return contour;
    }

    /** Where the contour was seen before. */
    ContourMemory memory() {
        return memory;
    }

    /** Latest rate of noise events per pixel and per µs, of each polarity. */
    double noisePerUs() {
        return noisePerUs;
    }

    /** Time in which the structure travels the pixels for which its contour is remembered. */
    long memoryUs(Motion motion) {
        return (long) Math.min(MAX_MEMORY_US, memoryPx / Math.max(motion.speed(contour.radius()), LEAST_SPEED) * 1e6);
    }

    /** Time for which the contour holds events: the lifetime, or less where noise would fill the contour. */
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
     * Notes a current event. Unless the claim is {@link Claim#REMEMBERED}, it is the event whose support was asked for
     * last.
     *
     * @return the hash of its tile
     */
    int take(int x, int y, long timeUs, int polarity, Claim claim, long lifetimeUs) {
        if (claim == Claim.REMEMBERED) {
            contour.add(x, y, timeUs, polarity);
            return memory.tile(x, y, timeUs);
        }
        contour.addLast(polarity);
        return memory.see(x, y, timeUs);
    }

    /** Returns the hash of the tile of the structure that an event lies on. */
    int tile(int x, int y, long timeUs) {
        return memory.tile(x, y, timeUs);
    }

    /** Notes a current event, whose {@link #tile} was asked for last. */
    void takeLocated(int x, int y, long timeUs, int polarity) {
        contour.add(x, y, timeUs, polarity);
        memory.seeLocated(timeUs);
    }

    /**
     * Share of the time for which the contour holds events that a place of the structure has been in sight, if it came
     * in over the border: 0 to 1.
     */
    double shareInSight(int x, int y, long timeUs, long lifetimeUs) {
        return Math.min(1, contour.inSightUs(x, y, timeUs) / heldUs(lifetimeUs));
    }

    /**
     * Drops events that are older than the time for which the contour holds them.
     *
     * @param noise noise events per pixel and per µs, of each polarity
     * @param either whether events of either polarity are expected where those of one were seen
     */
    void pass(long nowUs, double noise, boolean either, long lifetimeUs) {
        noisePerUs = noise;
        contour.expectEither(either);
        contour.fade(nowUs, heldUs(lifetimeUs));
    }

    /** Lets the contour follow a motion that is known a little better now, from the reference of that motion on. */
    void follow(Motion motion, long lifetimeUs) {
        contour.fade(motion.referenceUs, heldUs(lifetimeUs));
        contour.follow(motion);
    }

    /** Redraws the contour from the live events, along a motion that was known badly before. */
    void draw(LiveEvents live, Motion motion, long lifetimeUs) {
        contour.draw(live, motion, heldUs(lifetimeUs));
    }

    /**
     * Takes threshold, size and the centre of the motion from the contour as it lies now, and lets the memory follow.
     */
    void measure(LiveEvents live, Motion motion, long lifetimeUs) {
        contour.measure(live, motion, Noise.support(noisePerUs, heldUs(lifetimeUs)));
        motion.moveCentre(contour.centreX(), contour.centreY());
        remember(motion);
    }

    /** Lets the memory follow a motion up to the reference of that motion. */
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
