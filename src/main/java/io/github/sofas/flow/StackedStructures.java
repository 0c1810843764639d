package io.github.sofas.flow;

import io.github.sofas.flow.search.Structures;
import io.github.sofas.flow.track.TrackPlane;
import io.github.sofas.flow.track.TrackPlaneStack;

/** Hands the structures that are found to the stack of track planes: search and tracking do not know each other. */
final class StackedStructures implements Structures {
    private final TrackPlaneStack stack;
    private final Handed handed = new Handed();

    StackedStructures(TrackPlaneStack stack) {
        this.stack = stack;
    }

    @Override
    public boolean isFull() {
        return stack.isFull();
    }

    @Override
    public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
        handed.plane = stack.create(nowUs, vxPxPerS, vyPxPerS);
        return handed;
    }

    /** The structure that is handed over; the next one takes its place. */
    private final class Handed implements Structure {
        private TrackPlane plane;

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
            plane.addPast(x, y, timeUs, polarity);
        }

        @Override
        public void begin(long nowUs) {
            stack.begin(plane, nowUs);
        }

        @Override
        public boolean expects(int x, int y, long timeUs, int polarity) {
            return plane.support(x, y, timeUs, polarity) >= plane.threshold();
        }
    }
}
