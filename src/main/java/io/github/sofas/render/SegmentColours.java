package io.github.sofas.render;

import java.util.TreeMap;

/**
 * Colours of segments: each keeps its colour for life, and two that are seen together have different ones as long as
 * there are enough; beyond, two share one. A new segment gets the colour that has not been seen for longest.
 */
public final class SegmentColours {
    /** Segments remembered: ids rise, so that the lowest are long gone when there are so many. */
    private static final int MOST = 4096;

    private final int[] colours;
    private final TreeMap<Integer, Integer> placeById = new TreeMap<>();
    private final long[] lastSeen;
    private long clock;

    /** Makes the colours of a theme, none of them given to a segment yet. */
    public SegmentColours(Theme theme) {
        colours = theme.segments;
        lastSeen = new long[colours.length];
    }

    /** The colour of a segment as 0xRRGGBB; 0xRRGGBB of a new one where it has none yet. */
    public int rgb(int id) {
        clock++;
        Integer place = placeById.get(id);
        if (place == null) {
            place = longestUnseen();
            placeById.put(id, place);
            if (placeById.size() > MOST) {
                placeById.pollFirstEntry();
            }
        }
        lastSeen[place] = clock;
        return colours[place];
    }

    private int longestUnseen() {
        int longest = 0;
        for (int i = 1; i < colours.length; i++) {
            if (lastSeen[i] < lastSeen[longest]) {
                longest = i;
            }
        }
        return longest;
    }
}
