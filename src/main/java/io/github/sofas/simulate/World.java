package io.github.sofas.simulate;

import java.util.List;

/**
 * Everything that the camera sees: opaque objects before a background at rest, or a still scene in the light of a lamp
 * that flickers.
 *
 * @param objects the objects, front to back, at most {@value #MAX_OBJECTS}; none if there is a lamp
 * @param lamp the lamp; null if the light is even
 * @param durationS duration of the film, in s
 */
record World(List<MovingObject> objects, Lamp lamp, double durationS) {
    /** Most objects of a world: the renderer stores sets of objects as bits of a long. */
    static final int MAX_OBJECTS = 64;

    World {
        if (objects.size() > MAX_OBJECTS) {
            throw new IllegalArgumentException(
                    "a world holds at most " + MAX_OBJECTS + " objects but was given " + objects.size());
        }
        if (lamp != null && !objects.isEmpty()) {
            throw new IllegalArgumentException("a lamp lights a still scene only but there are " + objects.size()
                    + " objects");
        }
        objects = List.copyOf(objects);
    }

    /** A world in even light. */
    World(List<MovingObject> objects, double durationS) {
        this(objects, null, durationS);
    }
}
