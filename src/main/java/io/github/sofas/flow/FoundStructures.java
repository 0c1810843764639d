package io.github.sofas.flow;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.search.Recognition;
import io.github.sofas.flow.search.Structures;
import io.github.sofas.flow.track.FoundPlanes;
import io.github.sofas.flow.track.TrackPlane;
import io.github.sofas.flow.track.TrackPlaneStack;

/**
 * Makes track planes of the structures that the search finds. It links search and tracking, which do not know each
 * other.
 */
final class FoundStructures implements Structures {
    private final FoundPlanes planes;
    private final TrackPlaneStack stack;

    FoundStructures(TrackPlaneStack stack) {
        this.stack = stack;
        planes = stack.found();
    }

    @Override
    public boolean isFull() {
        return planes.isFull();
    }

    @Override
    public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
        return new Handed(planes.create(nowUs, vxPxPerS, vyPxPerS));
    }

    @Override
    public boolean takes(int x, int y, long timeUs, int polarity) {
        return planes.takes(x, y, timeUs, polarity);
    }

    @Override
    public void report(Recognition to, long nowUs) {
        for (int i = 0; i < stack.size(); i++) {
            TrackPlane plane = stack.plane(i);
            if (plane.isPredictive() && plane.isVelocityKnown()) {
                Recognition.Known known = to.know(plane.id(), plane.liveEvents());
                known.motion().copyFrom(plane.motion());
                plane.includeIn(known.box(), nowUs);
            }
        }
    }

    @Override
    public void see(int id, int x, int y, long timeUs, int polarity, long nowUs) {
        TrackPlane plane = stack.planeOf(id);
        if (plane != null) {
            stack.see(plane, x, y, timeUs, polarity, nowUs);
        }
    }

    /** A structure that the search hands over to its track plane. */
    private final class Handed implements Structure {
        private final TrackPlane plane;
        /** How many structures the plane had served, including this one; it may serve another one later. */
        private final int served;

        Handed(TrackPlane plane) {
            this.plane = plane;
            served = plane.served();
        }

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
            planes.addPast(plane, x, y, timeUs, polarity);
        }

        @Override
        public void begin(long nowUs) {
            planes.begin(plane, nowUs);
        }

        @Override
        public boolean expects(int x, int y, long timeUs, int polarity) {
            return plane.support(x, y, timeUs, polarity) >= plane.threshold();
        }

        @Override
        public boolean isTracked() {
            return plane.served() == served && stack.tracks(plane);
        }

        @Override
        public double speed() {
            return plane.speed();
        }

        @Override
        public void copyMotion(Motion motion) {
            motion.copyFrom(plane.motion());
        }

        @Override
        public boolean isAround(int x, int y, double marginPx, long nowUs) {
            return plane.isAround(x, y, marginPx, nowUs);
        }

        @Override
        public void see(int x, int y, long timeUs, int polarity, long nowUs) {
            stack.see(plane, x, y, timeUs, polarity, nowUs);
        }
    }
}
