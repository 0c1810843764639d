package io.github.sofas.flow;

/**
 * An immutable snapshot of one track plane: a structure that moves as a whole.
 *
 * @param id from 1; not used again before a reset
 * @param firstTimeUs time of its first event in µs
 * @param lastTimeUs time of its last event in µs
 * @param events number of events that were assigned to it, and to the segments that were merged into it
 * @param vxPxPerS last velocity to the right in px/s
 * @param vyPxPerS last velocity downwards in px/s
 * @param turnRadPerS last rotation in rad/s, positive clockwise as seen; 0 where none shows
 * @param growthPerS last growth in 1/s, half the divergence of its flow; 0 where none shows. For a structure that comes
 *     nearer, 1/growth is the time to contact
 * @param minX leftmost column of its contour at its last event; the box is clipped to the sensor
 * @param minY topmost row
 * @param maxX rightmost column, inclusive
 * @param maxY bottom row, inclusive
 * @param fate what became of it
 * @param mergedInto id of the segment that took it over; 0 unless {@link Fate#MERGED}
 */
public record Segment(int id, long firstTimeUs, long lastTimeUs, long events, float vxPxPerS, float vyPxPerS,
                      float turnRadPerS, float growthPerS, int minX, int minY, int maxX, int maxY, Fate fate,
                      int mergedInto) {

    /** What became of a track plane. */
    public enum Fate {
        /** It was tracked at the last event seen. */
        ALIVE,
        /** Another track plane described the same structure and took its events. */
        MERGED,
        /** It got too few events for its speed and contour, left the sensor, or its events contradicted its motion. */
        REMOVED
    }
}
