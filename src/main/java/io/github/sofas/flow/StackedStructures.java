package io.github.sofas.flow;

import io.github.sofas.flow.search.Structures;
import io.github.sofas.flow.track.TrackPlane;
import io.github.sofas.flow.track.TrackPlaneStack;

/** Hands the structures that are found to the stack of track planes: search and tracking do not know each other. */
final class StackedStructures implements Structures {
    private final TrackPlaneStack stack;

    StackedStructures(TrackPlaneStack stack) {
        this.stack = stack;
    }

    @Override
    public boolean isFull() {
        return stack.isFull();
    }

    @Override
    public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
        return new Handed(stack.create(nowUs, vxPxPerS, vyPxPerS));
    }

    /** A structure that is handed over. */
    private final class Handed implements Structure {
        private final TrackPlane plane;
        /** The plane's number while it tracks this structure: it serves another one later. */
        private final int id;

        Handed(TrackPlane plane) {
            this.plane = plane;
            id = plane.id();
        }

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

        @Override
        public boolean isTracked() {
            return plane.id() == id && stack.tracks(plane);
        }

        @Override
        public double speed() {
            return plane.speed();
        }

        @Override
        public double vxAt(int x, int y, long timeUs) {
            return plane.motion().vxAt(x, y, timeUs);
        }

        @Override
        public double vyAt(int x, int y, long timeUs) {
            return plane.motion().vyAt(x, y, timeUs);
        }

        @Override
        public boolean isAround(int x, int y, double marginPx, long nowUs) {
            return plane.isAround(x, y, marginPx, nowUs);
        }

        @Override
        public void see(int x, int y, long timeUs, int polarity, long nowUs) {
            plane.see(x, y, timeUs, polarity, nowUs);
        }
    }
}
