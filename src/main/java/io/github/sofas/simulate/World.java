package io.github.sofas.simulate;

import java.util.List;

/**
 * What the camera sees: opaque objects before a background that rests.
 *
 * @param objects front to back, at most {@value #MAX_OBJECTS}
 * @param durationS how long it is seen, in s
 */
record World(List<MovingObject> objects, double durationS) {
    /** The renderer keeps sets of objects as bits of a long. */
    static final int MAX_OBJECTS = 64;

    World {
        if (objects.size() > MAX_OBJECTS) {
            throw new IllegalArgumentException(
                    "a world holds at most " + MAX_OBJECTS + " objects but was given " + objects.size());
        }
        objects = List.copyOf(objects);
    }
}
