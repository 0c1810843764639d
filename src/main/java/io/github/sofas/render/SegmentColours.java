package io.github.sofas.render;

import java.util.TreeMap;

/**
 * Colours of segments. A segment keeps its colour for life. A new segment gets a colour that no other segment in the
 * picture has, and of these colours the one that differs most from its neighbours'. If all colours are in use, it gets
 * the colour of a segment far away.
 */
final class SegmentColours {
    /**
     * Number of segments remembered. Ids rise, so that the segments with the lowest ids have long ended when there are
     * more.
     */
    private static final int MOST = 4096;
    /** Distance, px, within which the exact distance of a neighbour matters little. */
    private static final double NEAR_PX = 15;

    private final int[] colours;
    /** How similar two colours look: the inverse square of their distance as the eye perceives it. */
    private final double[][] likeness;
    private final TreeMap<Integer, Integer> placeById = new TreeMap<>();

    /** Makes the colours of a theme. No segment has a colour yet. */
    SegmentColours(Theme theme) {
        colours = theme.segments;
        likeness = new double[colours.length][colours.length];
        for (int a = 0; a < colours.length; a++) {
            for (int b = 0; b < colours.length; b++) {
                double difference = difference(colours[a], colours[b]);
                likeness[a][b] = 1 / (difference * difference + 1e-4);
            }
        }
    }

    /** How different two colours look: the distance in Oklab (Ottosson 2020), 1 from black to white. */
    static double difference(int a, int b) {
        double[] first = oklab(a);
        double[] second = oklab(b);
        return Math.sqrt(Math.pow(first[0] - second[0], 2) + Math.pow(first[1] - second[1], 2)
            + Math.pow(first[2] - second[2], 2));
    }

    private static double[] oklab(int rgb) {
        double r = light(rgb >> 16 & 0xFF);
        double g = light(rgb >> 8 & 0xFF);
        double b = light(rgb & 0xFF);
        double l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
        double m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
        double s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
        return new double[] {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
    }

    /** Linear light that a screen emits for a value of sRGB. */
    private static double light(int value) {
        double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
    }

    /** Gives a colour to each of the segments that has none. */
    void assign(SeenSegments seen) {
        for (int i = 0; i < seen.size(); i++) {
            if (!placeById.containsKey(seen.id(i))) {
                remember(seen.id(i), leastAlike(seen, i));
            }
        }
    }

    /** Gives a segment the colour at a place of the theme, instead of any that it has. */
    void assign(int id, int place) {
        remember(id, place % colours.length);
    }

    private void remember(int id, int place) {
        placeById.put(id, place);
        if (placeById.size() > MOST) {
            placeById.pollFirstEntry();
        }
    }

    /** Place of the colour that clashes least with those of the segments seen. Unused colours come first. */
    private int leastAlike(SeenSegments seen, int segment) {
        double[] clash = new double[colours.length];
        boolean[] used = new boolean[colours.length];
        for (int i = 0; i < seen.size(); i++) {
            Integer place = placeById.get(seen.id(i));
            if (i != segment && place != null) {
                double distance = NEAR_PX + Math.hypot(seen.x(i) - seen.x(segment), seen.y(i) - seen.y(segment));
                used[place] = true;
                for (int k = 0; k < colours.length; k++) {
                    clash[k] += likeness[place][k] / (distance * distance);
                }
            }
        }
        int least = 0;
        for (int k = 1; k < colours.length; k++) {
            if (used[least] && !used[k] || used[least] == used[k] && clash[k] < clash[least]) {
                least = k;
            }
        }
        return least;
    }

    /** The colour of a segment as 0xRRGGBB. A segment that was never seen gets a colour by its id. */
    int rgb(int id) {
        if (!placeById.containsKey(id)) {
            assign(id, id);
        }
        return colours[placeById.get(id)];
    }
}
