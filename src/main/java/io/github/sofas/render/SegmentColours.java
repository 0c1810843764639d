package io.github.sofas.render;

import java.util.HashMap;
import java.util.Map;

/**
 * Colours of segments: each keeps its colour for life, and two that are seen together have different ones as long as
 * there are enough. A new segment gets the colour that has not been seen for longest.
 */
public final class SegmentColours {
    private final int[] colours;
    private final Map<Integer, Integer> placeById = new HashMap<>();
    private final int[] holder;
    private final long[] lastSeen;
    private long clock;

    /** Makes the colours of a theme, none of them given to a segment yet. */
    public SegmentColours(Theme theme) {
        colours = theme.segments;
        holder = new int[colours.length];
        lastSeen = new long[colours.length];
    }

    /** The colour of a segment as 0xRRGGBB; 0xRRGGBB of a new one where it has none yet. */
    public int rgb(int id) {
        clock++;
        Integer place = placeById.get(id);
        if (place == null) {
            place = longestUnseen();
            // one holder a colour: what has not been seen for long is forgotten, so that memory is bounded
            placeById.remove(holder[place]);
            holder[place] = id;
            placeById.put(id, place);
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
