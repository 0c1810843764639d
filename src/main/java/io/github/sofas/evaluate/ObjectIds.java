package io.github.sofas.evaluate;

import java.util.Arrays;

/** The objects of a recording, numbered from 0 in the order of their ids, and the event with which each appears. */
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

    /** How many objects there are. */
    int count() {
        return ids.length;
    }

    /** The id of an object. */
    int id(int index) {
        return ids[index];
    }

    /** The number of event i's object, -1 where it is noise. */
    int indexOf(int i) {
        return indexOfEvent[i];
    }

    /** The event with which an object appears. */
    int firstEvent(int index) {
        return firstEvents[index];
    }
}
