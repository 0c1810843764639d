package io.github.sofas.evaluate;

import java.util.Arrays;

/**
 * The objects of a recording, numbered from 0 in the order of their ids. The consecutive numbers serve as array indices
 * for figures by object. For each object, holds the event with which the object appears.
 */
final class ObjectIds {
    private final int[] ids;
    private final int[] firstEvents;
    private final int[] indexOfEvent;

    ObjectIds(GroundTruth truth) {
        ids = Arrays.stream(truth.object()).filter(id -> id != GroundTruth.NOISE).sorted().distinct().toArray();
        firstEvents = new int[ids.length];
        Arrays.fill(firstEvents, -1);
        indexOfEvent = new int[truth.size()];
        for (int i = 0; i < indexOfEvent.length; i++) {
            int id = truth.object()[i];
            int index = id == GroundTruth.NOISE ? -1 : Arrays.binarySearch(ids, id);
            indexOfEvent[i] = index;
            if (index >= 0 && firstEvents[index] < 0) {
                firstEvents[index] = i;
            }
        }
    }

    /** Number of objects. */
    int count() {
        return ids.length;
    }

    /** Id of an object. */
    int id(int index) {
        return ids[index];
    }

    /** Index of the object that caused event i; -1 for noise. */
    int indexOf(int i) {
        return indexOfEvent[i];
    }

    /** Number of the event with which an object appears. */
    int firstEvent(int index) {
        return firstEvents[index];
    }
}
