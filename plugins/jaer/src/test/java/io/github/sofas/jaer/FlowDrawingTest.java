package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jogamp.opengl.GL2;
import com.jogamp.opengl.util.gl2.GLUT;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.lang.reflect.Proxy;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventprocessing.EventFilter;
import org.junit.Before;
import org.junit.Test;

/** What is drawn, as calls of GL. */
public class FlowDrawingTest {
    private final Map<String, Integer> calls = new HashMap<>();
    private final Set<Float> pointSizes = new HashSet<>();
    private boolean failing;
    private final GL2 gl = (GL2) Proxy.newProxyInstance(getClass().getClassLoader(), new Class<?>[] {GL2.class},
        (proxy, method, arguments) -> {
            calls.merge(method.getName(), 1, Integer::sum);
            if (failing && method.getName().equals("glVertex2f")) {
                throw new IllegalStateException("lost context");
            }
            if (method.getName().equals("glGetIntegerv")) {
                System.arraycopy(new int[] {0, 0, 700, 500}, 0, (int[]) arguments[1], 0, 4);
            } else if (method.getName().equals("glGetFloatv")) {
                // 200 chip pixels in 700 of the screen's, 125 in 500
                ((float[]) arguments[1])[0] = 2f / 200;
                ((float[]) arguments[1])[5] = -2f / 125;
            } else if (method.getName().equals("glPointSize")) {
                pointSizes.add((Float) arguments[0]);
            }
            return null;
        });
    private SofasFlow filter;
    private PacketAdapter packet;
    private Sofas sofas;

    @Before
    public void track() {
        EventFilter.PREFERENCES.clear();
        AEChip chip = new AEChip();
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        filter = new SofasFlow(chip);
        GLUT.DRAWN.clear();
        packet = new PacketAdapter();
        sofas = new Sofas(Packets.SENSOR, SofasParameters.defaults());
        for (EventBatch batch : Packets.film()) {
            packet.read(Packets.of(batch), Packets.SENSOR);
            sofas.process(packet.batch(), packet.output());
        }
        assertTrue(!sofas.segments().isEmpty());
    }

    private int count(String call) {
        return calls.getOrDefault(call, 0);
    }

    private void assertBalanced() {
        assertEquals(1, count("glPushAttrib"));
        assertEquals(1, count("glPopAttrib"));
        assertEquals(1, count("glPushMatrix"));
        assertEquals(1, count("glPopMatrix"));
    }

    @Test
    public void everythingIsDrawnAndTheStateLeftAsItWas() {
        new FlowDrawing().draw(gl, sofas, packet, filter);
        assertBalanced();
        assertEquals(count("glBegin"), count("glEnd"));
        // events, the inset, what is behind all labels, and contour and arrow of each segment
        assertEquals(3 + 2 * sofas.segments().size(), count("glBegin"));
        // labels and the legend
        assertEquals(sofas.segments().size() + 1, GLUT.DRAWN.size());
        Segment segment = sofas.segments().get(0);
        // jAER's y is up
        assertTrue(GLUT.DRAWN.get(0), GLUT.DRAWN.get(0).startsWith(segment.id() + ": ("
            + Math.round(segment.vxPxPerS()) + ", " + Math.round(-segment.vyPxPerS()) + ") px/s, "));
    }

    @Test
    public void pointsFillAPixelOfTheChip() {
        new FlowDrawing().draw(gl, sofas, packet, filter);
        assertEquals(Set.of(3.5f), pointSizes);
    }

    @Test
    public void everyPartCanBeSwitchedOff() {
        filter.setEventColours(FlowDrawing.Colouring.NONE);
        filter.setContoursShown(false);
        filter.setSegmentVelocityShown(false);
        filter.setMetricShown(false);
        filter.setSegmentLabelsShown(false);
        filter.setLegendShown(false);
        new FlowDrawing().draw(gl, sofas, packet, filter);
        assertBalanced();
        assertEquals(0, count("glBegin"));
        assertEquals(List.of(), GLUT.DRAWN);
    }

    @Test
    public void stateIsLeftAsItWasWhereDrawingFails() {
        failing = true;
        try {
            new FlowDrawing().draw(gl, sofas, packet, filter);
        } catch (IllegalStateException e) {
            assertBalanced();
            return;
        }
        throw new AssertionError("the failure must come out");
    }

    @Test
    public void insetOfThePaperHasACellAProjection() {
        filter.setEventColours(FlowDrawing.Colouring.NONE);
        filter.setContoursShown(false);
        filter.setSegmentVelocityShown(false);
        filter.setSegmentLabelsShown(false);
        filter.setLegendShown(false);
        Sofas paper = new Sofas(Packets.SENSOR, SofasParameters.paper());
        packet.read(Packets.of(Packets.film().get(3)), Packets.SENSOR);
        paper.process(packet.batch(), packet.output());
        new FlowDrawing().draw(gl, paper, packet, filter);
        // four corners each, and of the frame
        assertEquals(4 * (9 * 9 + 1), count("glVertex2f"));
    }
}
