package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.flow.fit.MetricFit;
import java.util.List;
import org.junit.Test;

/** What a new structure gets of the events that come while it is refined. */
public class StructureSearchTest {
    private static final SofasParameters P = SofasParameters.defaults();
    private static final SensorSize SENSOR = new SensorSize(64, 48);
    private static final int ROWS = 30;

    /** Takes every structure, and counts them. */
    private static final class AllStructures implements Structures, Structures.Structure {
        private int begun;

        @Override
        public boolean isFull() {
            return false;
        }

        @Override
        public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
            return this;
        }

        @Override
        public void addPast(int x, int y, long timeUs, int polarity) {
        }

        @Override
        public void begin(long nowUs) {
            begun++;
        }

        @Override
        public boolean expects(int x, int y, long timeUs, int polarity) {
            return true;
        }
    }

    /**
     * Lets an edge of 100 px/s be found, which enters a ninth column while it is refined, and returns how many events
     * are left in the second slowest ring.
     *
     * @param column whether the ninth column has events
     * @param ofAnother events of that column that ring 0 is rid of, as another structure was given them
     */
    private static int left(boolean column, int ofAnother) {
        FlowPlane plane = new FlowPlane(SENSOR.width(), SENSOR.height(), P.search());
        AllStructures structures = new AllStructures();
        MetricFit fit = new MetricFit(SENSOR.width(), SENSOR.height(), MetricFit.CELL_PX, 4096, 300);
        StructureSearch search = new StructureSearch(plane, P.search(), fit, structures);
        List<Event> edge = Streams.edge(4, 9, ROWS, 0, 10_000);
        for (int i = 0; i < 9 * ROWS; i++) {
            if (i == 8 * ROWS) {
                plane.settle(71_000);
                search.run(0);
            }
            if (i < 8 * ROWS || column) {
                Event e = edge.get(i);
                plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
            }
        }
        int[] events = new int[ofAnother];
        for (int i = 0; i < ofAnother; i++) {
            events[i] = 8 * ROWS + i;
        }
        plane.takeOut(0, events, ofAnother);
        for (int i = 0; i < 2_000; i++) {
            search.run(0);
        }
        assertEquals("structures", 1, structures.begun);
        // the ring takes in what is left after 1/16 of the time of 6 px at 6.9 px/s: 55 ms
        plane.settle(140_000);
        return plane.count(1);
    }

    @Test
    public void newStructureGetsWhatCameWhileItWasRefined() {
        assertEquals(left(false, 0), left(true, 0));
    }

    @Test
    public void newStructureGetsNoEventThatAnotherHas() {
        assertEquals(left(true, 0) + 10, left(true, 10));
    }
}
