package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.HashMap;
import java.util.Map;
import org.junit.Test;

/** A textured wall that fills the picture and goes to the right by 150 px/s, so dense that it is measured on tiles. */
public class LoneWallTest {
    private static final SensorSize SENSOR = SimulationOptions.DAVIS240;
    private static final double PX_PER_S = 150;
    /** After 30 px of travel the wall has been one segment for long. */
    private static final long SETTLED_US = 200_000;
    private static final long UNTIL_US = 600_000;
    /** The wall's segment: the one that is found first. */
    private static final int WALL = 1;

    private static SimulatedRecording wall() {
        return SimulatedRecording.of(Scene.TEXTURED_PAN,
            SimulationOptions.defaults().withSpeedPxPerS(PX_PER_S).withDurationUs(UNTIL_US));
    }

    private static int[] segments(SensorSize sensor, EventBatch film) {
        FlowOutput flow = new FlowOutput(film.size());
        new Sofas(sensor, SofasParameters.defaults()).process(film, flow);
        return flow.segment;
    }

    private static void add(SimulatedRecording from, int i, long laterUs, EventBatch film) {
        film.add(from.timeUs[i] + laterUs, from.x[i], from.y[i], from.polarity[i]);
    }

    @Test
    public void whatComesInOverTheBorderIsTheWalls() {
        SimulatedRecording wall = wall();
        EventBatch film = new EventBatch(wall.size());
        for (int i = 0; i < wall.size(); i++) {
            add(wall, i, 0, film);
        }
        int[] segments = segments(SENSOR, film);
        int events = 0;
        int walls = 0;
        for (int i = 0; i < wall.size(); i++) {
            if (wall.timeUs[i] > SETTLED_US && wall.x[i] < 8 && wall.object[i] == 1) {
                events++;
                walls += segments[i] == WALL ? 1 : 0;
            }
        }
        assertTrue(walls + " of " + events, walls > 0.97 * events);
    }

    /** A hexagon that nothing is hidden by or hides, from {@link #SETTLED_US} on. */
    @Test
    public void whatAppearsBeforeTheWallGetsASegment() {
        SimulatedRecording wall = wall();
        SimulationOptions options = SimulationOptions.defaults();
        SimulatedRecording hexagon = SimulatedRecording.of(Scene.HEXAGON, options.withDirectionDeg(100)
            .withDurationUs(UNTIL_US - SETTLED_US).withDvs(options.dvs().withNoiseHzPerPx(0)));
        int n = wall.size() + hexagon.size();
        EventBatch film = new EventBatch(n);
        boolean[] isHexagon = new boolean[n];
        int w = 0;
        int h = 0;
        for (int i = 0; i < n; i++) {
            isHexagon[i] = w == wall.size()
                || h < hexagon.size() && hexagon.timeUs[h] + SETTLED_US < wall.timeUs[w];
            if (isHexagon[i]) {
                add(hexagon, h++, SETTLED_US, film);
            } else {
                add(wall, w++, 0, film);
            }
        }
        int[] segments = segments(SENSOR, film);
        Map<Integer, Integer> ofHexagon = new HashMap<>();
        int events = 0;
        for (int i = 0; i < n; i++) {
            if (isHexagon[i] && film.timeUs[i] > UNTIL_US - 100_000) {
                events++;
                ofHexagon.merge(segments[i], 1, Integer::sum);
            }
        }
        ofHexagon.remove(0);
        ofHexagon.remove(WALL);
        int most = ofHexagon.values().stream().mapToInt(Integer::intValue).max().orElse(0);
        assertTrue(most + " of " + events, most > 0.8 * events);
    }

    /** A strip of 150 px of a wall, which goes on from column 10, before nothing. */
    @Test
    public void noiseWhereAStructureWasIsNotIts() {
        SensorSize large = new SensorSize(346, 260);
        SimulatedRecording wall = SimulatedRecording.of(Scene.TEXTURED_PAN, SimulationOptions.defaults()
            .withSensor(large).withSpeedPxPerS(PX_PER_S).withDurationUs(1_000_000));
        EventBatch film = new EventBatch(wall.size());
        for (int i = 0; i < wall.size(); i++) {
            double onStrip = wall.x[i] - 10 - PX_PER_S * wall.timeUs[i] * 1e-6;
            if (wall.object[i] == 0 || onStrip >= 0 && onStrip < 150) {
                add(wall, i, 0, film);
            }
        }
        int[] segments = segments(large, film);
        int behind = 0;
        int withFlow = 0;
        for (int i = 0; i < film.size(); i++) {
            if (film.timeUs[i] > 400_000 && film.x[i] < PX_PER_S * film.timeUs[i] * 1e-6 - 20) {
                behind++;
                withFlow += segments[i] == 0 ? 0 : 1;
            }
        }
        assertTrue("events " + behind, behind > 1_000);
        assertEquals(0, withFlow);
    }
}
