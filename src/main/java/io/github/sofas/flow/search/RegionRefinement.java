package io.github.sofas.flow.search;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;
import java.util.Arrays;

/**
 * Finds the velocity of a dense region: from rest to the top of the metric of all its events, fit by fit. Each step
 * makes one fit, so that labelling continues in between.
 *
 * <p>Ours, because texture falls into hundreds of pieces in the flow plane, none of which shows a velocity before 4 px
 * of travel, and because the events on the pieces of a projection favour that projection. All events of a region are
 * sharpest along their motion from about 2 px of travel on if the texture has edges, and from 4 px on if it is smooth.
 * A wall that is found before 3 px of travel takes what moves before it along, which does not show yet.
 */
final class RegionRefinement {
    /** Distance of the first projections, in px at the ends of the window. */
    private static final double FIRST_PX = 1;
    /** Fewest events that are fitted, and most: of a region with more, its middle is fitted. */
    private static final int LEAST_EVENTS = 300;
    private static final int SAMPLE_EVENTS = 2048;
    /** Least and greatest travel of a region, in px. What travels farther unexplained is left of a known texture. */
    private static final double LEAST_TRAVEL_PX = 3;
    private static final double MOST_TRAVEL_PX = 5;
    /** Standard deviations by which the metric must pass that at rest, and of those the share after the first fit. */
    private static final double LEAST_SIGMAS = 7;
    private static final double HOPEFUL_SHARE = 0.4;
    /**
     * Least metric per event at rest. Texture has more than twice as much after 3 px of travel. Noise has next to
     * none, and is given up after one vote of each event.
     */
    private static final double LEAST_DENSITY = 0.2;
    /** Cells along a side of what is fitted, and the share of them on which texture has events. */
    private static final int CELLS = 16;
    private static final double LEAST_FILL = 0.6;
    /**
     * Parts along a side of what is fitted, and the share of them on which the events of a texture meet. An outline in
     * noise, which fills cells, too, crosses fewer.
     */
    private static final int PARTS = 4;
    private static final double LEAST_SHARE = 0.75;
    /** Least metric per event of a part, on cells of a pixel, where its events meet. */
    private static final double LEAST_DENSITY_OF_PART = 0.25;
    private static final int COLUMNS = DenseRegions.SIDE_PX;

    private final DenseRegions regions;
    private final RecentEvents events;
    private final MetricFit fit;
    private final VelocityClimb climb;
    private final boolean[] isFilled = new boolean[CELLS * CELLS];
    /** The events along their motion: by pixel of the region, those of polarity +1 less those of -1. */
    private final int[] picture = new int[COLUMNS * COLUMNS];
    private final int[] ofPart = new int[PARTS * PARTS];
    /** The region, with the number of its newest event, and how many it had, when it was begun with. */
    private int region;
    private int newest;
    private int held;
    /** The square that is fitted: its side in px and its place; and since when its events are held. */
    private int side;
    private int left;
    private int top;
    private long oldestUs;
    private double windowS;
    private double atRest;
    private boolean isOver = true;
    private boolean isStructure;

    RegionRefinement(DenseRegions regions, RecentEvents events, MetricFit fit) {
        this.regions = regions;
        this.events = events;
        this.fit = fit;
        climb = new VelocityClimb(fit);
    }

    /** Whether any region is due. */
    boolean isAnyDue() {
        return regions.isAnyDue();
    }

    /** Begins with the next region that is due; returns the number of events gone through. */
    int begin() {
        region = regions.next();
        newest = regions.newest(region);
        held = regions.count(region);
        load();
        regions.forgetIfFull(region);
        isStructure = false;
        isOver = true;
        if (fit.size() >= LEAST_EVENTS && windowS > 0 && isFilled()) {
            atRest = fit.metric();
            isOver = atRest < LEAST_DENSITY * fit.size();
            climb.begin(0, 0, windowS, FIRST_PX);
        }
        return held;
    }

    /** Takes the events of a square in the middle of the region, so small that it has no more than are fitted. */
    private void load() {
        side = DenseRegions.SIDE_PX;
        for (int its = held; its > SAMPLE_EVENTS; its /= 4) {
            side /= 2;
        }
        left = regions.left(region) + (DenseRegions.SIDE_PX - side) / 2;
        top = regions.top(region) + (DenseRegions.SIDE_PX - side) / 2;
        fit.clear();
        Arrays.fill(isFilled, false);
        // the recent events may no longer hold the first ones
        oldestUs = Math.max(regions.sinceUs(region), events.timeUs(events.oldest()));
        windowS = (events.timeUs(newest) - oldestUs) * 1e-6;
        int event = newest;
        for (int k = 0; isHeld(k, event) && fit.size() < fit.capacity(); k++) {
            if (isFitted(event)) {
                fit.add(events.x(event), events.y(event), (float) tauS(event), 0, 0, events.sign(event));
                isFilled[cell(events.y(event) - top) * CELLS + cell(events.x(event) - left)] = true;
            }
            event = regions.before(event);
        }
    }

    private int cell(int column) {
        return column * CELLS / side;
    }

    /** Whether events fill the square, as those of an outline do not. */
    private boolean isFilled() {
        int filled = 0;
        for (boolean is : isFilled) {
            filled += is ? 1 : 0;
        }
        return filled >= LEAST_FILL * isFilled.length;
    }

    /** Whether an event lies on the square, and no structure took it. */
    private boolean isFitted(int event) {
        int x = events.x(event) - left;
        int y = events.y(event) - top;
        return events.sign(event) != 0 && x >= 0 && y >= 0 && x < side && y < side;
    }

    /** Time of an event from the middle of the window, in s. */
    private double tauS(int event) {
        return (events.timeUs(event) - oldestUs) * 1e-6 - windowS / 2;
    }

    private boolean isHeld(int k, int event) {
        return k < held && event - events.oldest() >= 0;
    }

    /** Makes the next fit. */
    void step() {
        VelocityTop top = climb.step();
        double sigmas = (top.metric() - atRest) / MetricFit.sd(top.metric());
        if (climb.fits() == 1 && sigmas < HOPEFUL_SHARE * LEAST_SIGMAS) {
            isOver = true;
        } else if (climb.hasArrived()) {
            isOver = true;
            isStructure = sigmas > LEAST_SIGMAS && climb.isKnown() && hasTravelled() && isTexture();
            if (isStructure) {
                regions.forget(region);
            }
        }
    }

    private boolean hasTravelled() {
        double travelPx = Math.sqrt(vx() * vx() + vy() * vy()) * windowS;
        return travelPx > LEAST_TRAVEL_PX && travelPx < MOST_TRAVEL_PX;
    }

    /** Whether the events meet in most parts of the square. */
    private boolean isTexture() {
        draw();
        int meeting = 0;
        for (int part = 0; part < ofPart.length; part++) {
            meeting += squares(part) - ofPart[part] > LEAST_DENSITY_OF_PART * ofPart[part] ? 1 : 0;
        }
        return meeting >= LEAST_SHARE * ofPart.length;
    }

    /** Draws the events where they lie in the middle of the window, and counts them by part. */
    private void draw() {
        Arrays.fill(picture, 0);
        Arrays.fill(ofPart, 0);
        int event = newest;
        for (int k = 0; isHeld(k, event); k++) {
            if (isFitted(event)) {
                int x = (int) Math.floor(events.x(event) - left - vx() * tauS(event) + 0.5);
                int y = (int) Math.floor(events.y(event) - top - vy() * tauS(event) + 0.5);
                if (isInside(x) && isInside(y)) {
                    picture[y * COLUMNS + x] += events.sign(event);
                    ofPart[part(y) * PARTS + part(x)]++;
                }
            }
            event = regions.before(event);
        }
    }

    private boolean isInside(int column) {
        return column >= 0 && column < side;
    }

    private int part(int column) {
        return column * PARTS / side;
    }

    /** Sum of the squares of a part of the picture. */
    private long squares(int part) {
        int its = side / PARTS;
        int firstX = part % PARTS * its;
        int firstY = part / PARTS * its;
        long squares = 0;
        for (int y = firstY; y < firstY + its; y++) {
            for (int x = firstX; x < firstX + its; x++) {
                squares += (long) picture[y * COLUMNS + x] * picture[y * COLUMNS + x];
            }
        }
        return squares;
    }

    /** Whether no fit is left to make. */
    boolean isOver() {
        return isOver;
    }

    /** Whether the region shows a structure, once the refinement is over. */
    boolean isStructure() {
        return isStructure;
    }

    /** Leftmost column of the region. */
    int left() {
        return regions.left(region);
    }

    /** Topmost row of the region. */
    int top() {
        return regions.top(region);
    }

    /** Velocity of the structure in px/s. */
    double vx() {
        return climb.vx();
    }

    double vy() {
        return climb.vy();
    }

    /** Time from the first to the last event of the region, in s. */
    double windowS() {
        return windowS;
    }
}
