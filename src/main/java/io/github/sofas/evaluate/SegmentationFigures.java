package io.github.sofas.evaluate;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * How well segments represent objects, for one object or for all objects together.
 *
 * <p>Time is cut into windows (50 ms by default). In a window, O is the set of an object's events, labelled or not, and
 * S is the set of events that carry a segment's id. A pair of a window and an object counts if O has at least
 * {@value #MIN_OBJECT_EVENTS} events. All pairs have the same weight.
 * <pre>
 *   intersection over union    max over segments of |O and S| / |O or S|; 0 if no event of O is labelled
 *   part of an object          segment with |O and S| at least 5 % of the labelled events of O, and 3 events
 *   parts per object           mean number of parts over the pairs that have one
 *   object of a part           object with |O and S| at least 5 % of S's events of any object, and 3 events
 *   objects per part           mean number of objects over the windows' segments that have one
 *   identity change            the best segment differs from that of the object's last pair that had one
 * </pre>
 * S includes noise events, so that a method that labels everything near an object does not look better for it.
 * {@link #meanIouWithoutNoise} leaves noise out of S, and shows how much of the loss is due to noise. Parts are counted
 * among labelled events only, so that a missing label does not lower their number. The intersection over union already
 * penalises missing labels.
 *
 * <p>The first label of an object is on the object's first labelled event that later events confirm. Of this event and
 * the object's next {@value #CONFIRMING_EVENTS} events (or all that are left), at least half must be labelled. A single
 * stray label is thus no detection. The travel until the first label is the sum of |v| dt over the object's events from
 * its appearance to this event. Time and travel until the first label are taken over the whole recording, including its
 * beginning.
 *
 * @param object id of the object; {@link FlowFigures#ALL_OBJECTS} for all objects together
 * @param pairs number of pairs of a window and an object that count
 * @param meanIou mean intersection over union, 0 to 1
 * @param meanIouWithoutNoise the same with noise left out of the segments
 * @param worstIou smallest intersection over union of a pair
 * @param partsPerObject mean number of parts; 0 if no pair has a part
 * @param objectsPerPart mean number of objects over the parts that hold the object; 0 if there is no such part
 * @param identityChanges number of changes of the best segment
 * @param labelled number of objects that were ever labelled
 * @param firstLabelledUs time from appearance to the first label, in µs; the longest of several objects; 0 if no
 *     object was ever labelled
 * @param firstLabelledPx travel from appearance to the first label, in px; the longest of several objects
 */
public record SegmentationFigures(int object, long pairs, double meanIou, double meanIouWithoutNoise, double worstIou,
                                  double partsPerObject, double objectsPerPart, long identityChanges, int labelled,
                                  long firstLabelledUs, double firstLabelledPx) {
    /** Smallest number of an object's events in a window for the pair to count. */
    public static final int MIN_OBJECT_EVENTS = 10;
    /** Smallest share of events that makes a part. */
    public static final double PART_SHARE = 0.05;
    /** Smallest number of events that makes a part. */
    public static final int MIN_PART_EVENTS = 3;
    /** Number of events after a label among which other labels must confirm it. */
    public static final int CONFIRMING_EVENTS = 19;

    /** Accumulates windows, for each object and for all objects together. */
    static final class Gatherer {
        private final GroundTruth truth;
        private final FlowEstimate estimate;
        private final ObjectIds ids;
        private final Sum[] sums;
        private final Sum all = new Sum();
        private final int[] bestBefore;

        private static final class Sum {
            long pairs;
            double iou;
            double iouWithoutNoise;
            double worstIou = 1;
            long pairsWithParts;
            long parts;
            long partsWithObjects;
            long objects;
            long identityChanges;
        }

        /** A segment in a window: its number of events by object, with noise as the last entry. */
        private static final class Part {
            final int[] events;
            int all;

            Part(int objects) {
                events = new int[objects + 1];
            }
        }

        Gatherer(GroundTruth truth, FlowEstimate estimate, ObjectIds ids) {
            this.truth = truth;
            this.estimate = estimate;
            this.ids = ids;
            sums = new Sum[ids.count()];
            for (int o = 0; o < sums.length; o++) {
                sums[o] = new Sum();
            }
            bestBefore = new int[ids.count()];
        }

        /** Adds the window that holds the events with numbers {@code from} to {@code until}, exclusive. */
        void addWindow(int from, int until) {
            int count = ids.count();
            int[] events = new int[count];
            int[] labelled = new int[count];
            Map<Integer, Part> parts = new HashMap<>();
            for (int i = from; i < until; i++) {
                int object = ids.indexOf(i);
                if (object >= 0) {
                    events[object]++;
                }
                if (estimate.hasFlow(i)) {
                    Part part = parts.computeIfAbsent(estimate.segment(i), id -> new Part(count));
                    part.events[object >= 0 ? object : count]++;
                    part.all++;
                    if (object >= 0) {
                        labelled[object]++;
                    }
                }
            }
            for (int o = 0; o < count; o++) {
                if (events[o] >= MIN_OBJECT_EVENTS) {
                    addPair(o, events[o], labelled[o], parts);
                }
            }
            addObjectsOfParts(parts);
        }

        private void addPair(int o, int events, int labelled, Map<Integer, Part> parts) {
            double best = 0;
            double bestWithoutNoise = 0;
            int bestSegment = 0;
            int held = 0;
            for (Map.Entry<Integer, Part> entry : parts.entrySet()) {
                Part part = entry.getValue();
                int common = part.events[o];
                double iou = (double) common / (events + part.all - common);
                int withoutNoise = part.all - part.events[ids.count()];
                // The smaller id wins a tie, so that the result does not depend on the order of a hash map.
                if (iou > best || iou == best && iou > 0 && entry.getKey() < bestSegment) {
                    best = iou;
                    bestSegment = entry.getKey();
                }
                bestWithoutNoise = Math.max(bestWithoutNoise, (double) common / (events + withoutNoise - common));
                if (common >= MIN_PART_EVENTS && common >= PART_SHARE * labelled) {
                    held++;
                }
            }
            boolean changed = bestSegment != 0 && bestBefore[o] != 0 && bestSegment != bestBefore[o];
            if (bestSegment != 0) {
                bestBefore[o] = bestSegment;
            }
            for (Sum sum : new Sum[] {sums[o], all}) {
                sum.pairs++;
                sum.iou += best;
                sum.iouWithoutNoise += bestWithoutNoise;
                sum.worstIou = Math.min(sum.worstIou, best);
                if (held > 0) {
                    sum.pairsWithParts++;
                    sum.parts += held;
                }
                if (changed) {
                    sum.identityChanges++;
                }
            }
        }

        private void addObjectsOfParts(Map<Integer, Part> parts) {
            for (Part part : parts.values()) {
                int ofObjects = part.all - part.events[ids.count()];
                Set<Integer> held = new HashSet<>();
                for (int o = 0; o < ids.count(); o++) {
                    if (part.events[o] >= MIN_PART_EVENTS && part.events[o] >= PART_SHARE * ofObjects) {
                        held.add(o);
                    }
                }
                if (!held.isEmpty()) {
                    all.partsWithObjects++;
                    all.objects += held.size();
                }
                for (int o : held) {
                    sums[o].partsWithObjects++;
                    sums[o].objects += held.size();
                }
            }
        }

        /** Returns the figures of one object. */
        SegmentationFigures figures(int o) {
            int first = ids.firstEvent(o);
            int labelled = firstLabelledEvent(o);
            if (labelled < 0) {
                return figures(ids.id(o), sums[o], 0, 0, 0);
            }
            return figures(ids.id(o), sums[o], 1, truth.timeUs()[labelled] - truth.timeUs()[first],
                    travelPx(o, first, labelled));
        }

        /** Returns the figures of all objects together. */
        SegmentationFigures figuresOfAll() {
            int labelled = 0;
            long longestUs = 0;
            double longestPx = 0;
            for (int o = 0; o < ids.count(); o++) {
                SegmentationFigures figures = figures(o);
                labelled += figures.labelled;
                longestUs = Math.max(longestUs, figures.firstLabelledUs);
                longestPx = Math.max(longestPx, figures.firstLabelledPx);
            }
            return figures(FlowFigures.ALL_OBJECTS, all, labelled, longestUs, longestPx);
        }

        private static SegmentationFigures figures(int id, Sum sum, int labelled, long firstUs, double firstPx) {
            double pairs = Math.max(sum.pairs, 1);
            return new SegmentationFigures(id, sum.pairs, sum.iou / pairs, sum.iouWithoutNoise / pairs,
                    sum.pairs == 0 ? 0 : sum.worstIou, FlowFigures.share(sum.parts, sum.pairsWithParts),
                    FlowFigures.share(sum.objects, sum.partsWithObjects), sum.identityChanges, labelled, firstUs,
                    firstPx);
        }

        private int firstLabelledEvent(int o) {
            int[] own = new int[truth.size()];
            int n = 0;
            for (int i = ids.firstEvent(o); i < own.length; i++) {
                if (ids.indexOf(i) == o) {
                    own[n++] = i;
                }
            }
            int labelled = 0;
            int end = 0;
            for (int k = 0; k < n; k++) {
                while (end < n && end <= k + CONFIRMING_EVENTS) {
                    labelled += estimate.hasFlow(own[end++]) ? 1 : 0;
                }
                if (estimate.hasFlow(own[k])) {
                    if (2 * labelled >= end - k) {
                        return own[k];
                    }
                    labelled--;
                }
            }
            return -1;
        }

        private double travelPx(int o, int first, int last) {
            double px = 0;
            long before = truth.timeUs()[first];
            for (int i = first; i <= last; i++) {
                if (ids.indexOf(i) == o) {
                    px += truth.speed(i) * (truth.timeUs()[i] - before) * 1e-6;
                    before = truth.timeUs()[i];
                }
            }
            return px;
        }
    }
}
