package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jogamp.opengl.GL2;
import com.jogamp.opengl.util.awt.TextRenderer;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.lang.reflect.Proxy;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventprocessing.EventFilter;
import org.junit.Before;
import org.junit.Test;

/** What is drawn, as calls of GL. */
public class FlowDrawingTest {
    private final Map<String, Integer> calls = new HashMap<>();
    private int[] viewport = {0, 0, 700, 500};
    private boolean failing;
    private final GL2 gl = (GL2) Proxy.newProxyInstance(getClass().getClassLoader(), new Class<?>[] {GL2.class},
        (proxy, method, arguments) -> {
            calls.merge(method.getName(), 1, Integer::sum);
            if (failing && method.getName().equals("glVertex2f")) {
                throw new IllegalStateException("lost context");
            }
            if (method.getName().equals("glGetIntegerv")) {
                System.arraycopy(viewport, 0, (int[]) arguments[1], 0, 4);
            } else if (method.getName().equals("glGetFloatv")) {
                float[] matrix = (float[]) arguments[1];
                boolean projection = (Integer) arguments[0] == GL2.GL_PROJECTION_MATRIX;
                // 200 chip pixels in the width of the picture, 142.86 in its height, from -10 and -5 on
                matrix[0] = projection ? 2f / 200 : 1;
                matrix[5] = projection ? 2f / 142.857f : 1;
                matrix[12] = projection ? 2f * 10 / 200 - 1 : 0;
                matrix[13] = projection ? 2f * 5 / 142.857f - 1 : 0;
            }
            return null;
        });
    private SofasFlow filter;
    private final ShownEvents events = new ShownEvents();
    private Sofas sofas;

    @Before
    public void track() {
        EventFilter.PREFERENCES.clear();
        AEChip chip = new AEChip();
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        filter = new SofasFlow(chip);
        TextRenderer.DRAWN.clear();
        sofas = new Sofas(Packets.SENSOR, SofasParameters.defaults());
        FlowOutput flow = new FlowOutput(500);
        for (EventBatch batch : Packets.film()) {
            sofas.process(batch, flow);
            events.add(batch, flow);
            events.setDrawn();
        }
        assertTrue(!sofas.segments().isEmpty());
    }

    private void draw(int behind) {
        new FlowDrawing().draw(gl, Snapshot.of(sofas, filter.isContoursShown(), filter.isMetricShown()), events,
            behind, filter);
    }

    private int count(String call) {
        return calls.getOrDefault(call, 0);
    }

    private void assertBalanced() {
        assertEquals(1, count("glPushAttrib"));
        assertEquals(1, count("glPopAttrib"));
        assertEquals(1, count("glPushMatrix"));
        assertEquals(1, count("glPopMatrix"));
        assertEquals(count("glBegin"), count("glEnd"));
    }

    @Test
    public void everythingIsDrawnAndTheStateLeftAsItWas() {
        filter.setMetricShown(true);
        draw(0);
        assertBalanced();
        Segment segment = sofas.segments().get(0);
        // jAER's y is up
        String label = segment.id() + ": (" + Math.round(segment.vxPxPerS()) + ", " + Math.round(-segment.vyPxPerS())
            + ") px/s, ";
        assertTrue(TextRenderer.DRAWN.toString(), TextRenderer.DRAWN.stream().anyMatch(line -> line.startsWith(label)));
        assertTrue(TextRenderer.DRAWN.toString(),
            TextRenderer.DRAWN.contains("search: direction; 4 to 1500 px/s outwards"));
    }

    @Test
    public void everyEventWithFlowIsASquareOfItsPixel() {
        filter.setContoursShown(false);
        filter.setSegmentVelocityShown(false);
        filter.setSegmentLabelsShown(false);
        filter.setLegendShown(false);
        draw(0);
        assertEquals(4 * events.withFlow(), count("glVertex2f"));
    }

    @Test
    public void everyPartCanBeSwitchedOff() {
        filter.setEventColours(FlowDrawing.Colouring.NONE);
        filter.setContoursShown(false);
        filter.setSegmentVelocityShown(false);
        filter.setSegmentLabelsShown(false);
        filter.setLegendShown(false);
        draw(0);
        assertBalanced();
        assertEquals(0, count("glVertex2f"));
        assertEquals(List.of(), TextRenderer.DRAWN);
    }

    @Test
    public void stateIsLeftAsItWasWhereDrawingFails() {
        failing = true;
        try {
            draw(0);
        } catch (IllegalStateException e) {
            assertEquals(1, count("glPopMatrix"));
            assertEquals(1, count("glPopAttrib"));
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
        filter.setMetricShown(true);
        sofas = new Sofas(Packets.SENSOR, SofasParameters.paper());
        sofas.process(Packets.film().get(3), new FlowOutput(500));
        draw(0);
        // four corners each, of what is behind them, and of what is behind the title
        assertEquals(4 * (9 * 9 + 1 + 1), count("glVertex2f"));
    }

    @Test
    public void metricsAreNotDrawnAtFirst() {
        draw(0);
        assertTrue(TextRenderer.DRAWN.stream().noneMatch(line -> line.startsWith("search")));
    }

    @Test
    public void legendSaysHowFarTheEngineIsBehind() {
        draw(2);
        assertTrue(TextRenderer.DRAWN.toString(),
            TextRenderer.DRAWN.stream().anyMatch(line -> line.endsWith("2 packets behind")));
    }

    @Test
    public void legendTakesMoreLinesInASmallWindow() {
        filter.setSegmentLabelsShown(false);
        viewport = new int[] {0, 0, 200, 143};
        draw(0);
        assertTrue(TextRenderer.DRAWN.toString(), TextRenderer.DRAWN.size() > 1);
        assertEquals("SOFAS: 2 segments", TextRenderer.DRAWN.get(0).split(";")[0]);
        for (String line : TextRenderer.DRAWN) {
            // letters are half as wide as high, and the chip begins at pixel 10
            assertTrue(line, 10 + line.length() * TextRenderer.letters / 2 <= 200);
        }
    }

    @Test
    public void lettersGrowWithTheFontSizeAndThePicture() {
        draw(0);
        // 3.5 screen pixels a chip pixel: 0.8 of it for each unit of the font size
        assertEquals(17, TextRenderer.letters);
        filter.fontSize = 10;
        draw(0);
        assertEquals(28, TextRenderer.letters);
        viewport = new int[] {0, 0, 200, 143};
        draw(0);
        assertEquals(18, TextRenderer.letters);
    }

    @Test
    public void oneSegmentIsNotSegments() {
        sofas.setParameters(SofasParameters.defaults().with("maxTrackPlanes", 1));
        sofas.process(new EventBatch(1), new FlowOutput(1));
        draw(0);
        assertEquals("SOFAS: 1 segment", TextRenderer.DRAWN.get(0).split(";")[0]);
    }

    private static Segment segment(float turnRadPerS, float growthPerS) {
        return new Segment(7, 1_000_000, 3_460_000, 900, -12.6f, 3.2f, turnRadPerS, growthPerS, 3, 4, 10, 20,
            Segment.Fate.ALIVE, 0);
    }

    @Test
    public void labelSaysTurnAndGrowthWhereTheyAreSure() {
        // 8 x 17 pixels: the outline is 9.4 from the middle, and must have moved by 3 px in 2.46 s
        assertEquals("7: (-13, -3) px/s, 2.5 s", FlowDrawing.label(segment(0, 0)));
        assertEquals("7: (-13, -3) px/s, 2.5 s", FlowDrawing.label(segment(0.04f, -0.004f)));
        assertEquals("7: (-13, -3) px/s, 2.5 s, turns right 0.5 rad/s", FlowDrawing.label(segment(0.52f, 0)));
        assertEquals("7: (-13, -3) px/s, 2.5 s, turns left 0.5 rad/s, grows 0.25/s",
            FlowDrawing.label(segment(-0.52f, 0.25f)));
        assertEquals("7: (-13, -3) px/s, 2.5 s, shrinks 0.25/s", FlowDrawing.label(segment(0, -0.25f)));
    }

    @Test
    public void colourWheelIsShownWhereColoursAreDirections() {
        assertEquals(false, filter.displayColorWheelLegend);
        filter.setEventColours(FlowDrawing.Colouring.FLOW);
        assertEquals(true, filter.displayColorWheelLegend);
        filter.setEventColours(FlowDrawing.Colouring.SEGMENT);
        assertEquals(false, filter.displayColorWheelLegend);
        filter.setDisplayVectorsEnabled(true);
        assertEquals(true, filter.displayColorWheelLegend);
    }
}
