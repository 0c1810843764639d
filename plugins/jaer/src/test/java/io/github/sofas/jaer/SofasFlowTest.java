package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.SofasParameters.Preset;
import java.beans.BeanInfo;
import java.beans.IntrospectionException;
import java.beans.Introspector;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyDescriptor;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicReference;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import net.sf.jaer.Description;
import net.sf.jaer.Help;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.eventprocessing.EventFilter;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/** The filter in a model of its host. */
public class SofasFlowTest {
    private static final List<EventBatch> FILM = Packets.film();

    private final AEChip chip = new AEChip();
    private final List<String> warnings = new ArrayList<>();
    private final Handler handler = new Handler() {
        @Override
        public void publish(LogRecord entry) {
            if (entry.getLevel().intValue() >= java.util.logging.Level.WARNING.intValue()) {
                warnings.add(entry.getMessage());
            }
        }

        @Override
        public void flush() {
        }

        @Override
        public void close() {
        }
    };

    @Before
    public void prepare() {
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        EventFilter.PREFERENCES.clear();
        EventFilter.log.addHandler(handler);
        EventFilter.log.setUseParentHandlers(false);
    }

    @After
    public void tidyUp() {
        EventFilter.log.removeHandler(handler);
    }

    private SofasFlow filter() {
        SofasFlow filter = new SofasFlow(chip);
        filter.initFilter();
        filter.setFilterEnabled(true);
        filter.setEngineAwaited(true);
        return filter;
    }

    /** What the engine says of the film, in jAER's axes, a line an event; the value of no flow is 0. */
    private static List<String> expected(SofasParameters parameters) {
        Sofas sofas = new Sofas(Packets.SENSOR, parameters);
        FlowOutput flow = new FlowOutput(500);
        List<String> lines = new ArrayList<>();
        for (EventBatch batch : FILM) {
            sofas.process(batch, flow);
            for (int i = 0; i < batch.size(); i++) {
                lines.add(batch.timeUs[i] + " " + batch.x[i] + " " + (Packets.SENSOR.height() - 1 - batch.y[i]) + " "
                    + (batch.polarity[i] > 0 ? 1 : 0) + " " + flow.vxPxPerS[i] + " " + -flow.vyPxPerS[i]);
            }
        }
        return lines;
    }

    private static void show(SofasFlow filter) {
        for (EventBatch batch : FILM) {
            filter.filterPacket(Packets.of(batch));
        }
    }

    @Test
    public void handsOverTheEnginesFlowOfEveryEventInJaersAxes() {
        for (Preset preset : Preset.values()) {
            SofasFlow filter = filter();
            filter.setPreset(preset);
            show(filter);
            assertEquals(expected(SofasParameters.of(preset)), filter.good);
            assertEquals(FILM.size(), filter.getMotionFlowStatistics().packets);
            assertTrue(filter.engineNs() > 0);
        }
    }

    @Test
    public void jaersClockOfProcessingStartsBeforeTheEngine() {
        SofasFlow filter = filter();
        List<Integer> seen = new ArrayList<>();
        filter.clockStarted = () -> seen.add(filter.lastBatch().size());
        filter.filterPacket(Packets.of(FILM.get(0)));
        assertEquals(List.of(0), seen);
    }

    @Test
    public void rawEventsOrFlowEventsGoOn() {
        SofasFlow filter = filter();
        EventPacket<?> packet = Packets.of(FILM.get(0));
        assertSame(packet, filter.filterPacket(packet));
        filter.displayRawInput = false;
        assertTrue(filter.filterPacket(packet) != packet);
    }

    @Test
    public void noAndEmptyPacketsGoThrough() {
        SofasFlow filter = filter();
        assertNull(filter.filterPacket(null));
        EventPacket<?> empty = Packets.of();
        assertSame(empty, filter.filterPacket(empty));
        assertEquals(List.of(), filter.good);
    }

    @Test
    public void chipWithoutOrWithTooManyPixelsGetsItsPacketsBack() {
        chip.sizeX = 0;
        SofasFlow filter = filter();
        EventPacket<?> packet = Packets.of(FILM.get(0));
        assertSame(packet, filter.filterPacket(packet));
        chip.sizeX = 5000;
        assertSame(packet, filter.filterPacket(packet));
        assertEquals(List.of(), filter.good);
    }

    @Test
    public void otherChipBeginsAnew() {
        SofasFlow filter = filter();
        show(filter);
        int resets = filter.resets;
        chip.sizeX = 64;
        filter.filterPacket(Packets.of(FILM.get(0)));
        assertEquals(resets + 1, filter.resets);
        // of the wider chip's events only those on the new one
        assertTrue(filter.lastBatch().size() > 0);
        for (int i = 0; i < filter.lastBatch().size(); i++) {
            assertTrue(filter.lastBatch().x[i] < 64);
        }
    }

    @Test
    public void rewindBeginsAnew() {
        SofasFlow filter = filter();
        show(filter);
        List<String> first = List.copyOf(filter.good);
        filter.good.clear();
        filter.resetFilter();
        show(filter);
        assertEquals(first, filter.good);
    }

    @Test
    public void timestampsResetBeginsAnew() {
        SofasFlow filter = filter();
        int resets = filter.resets;
        filter.propertyChange(new PropertyChangeEvent(this, "timestampsReset", null, null));
        assertEquals(resets + 1, filter.resets);
        filter.setFilterEnabled(false);
        filter.propertyChange(new PropertyChangeEvent(this, "timestampsReset", null, null));
        assertEquals(resets + 1, filter.resets);
    }

    @Test
    public void trueMotionIsAskedOfInertialSamplesAndEventsInOrder() {
        SofasFlow filter = filter();
        filter.measureAccuracy = true;
        var packet = Packets.mixed();
        filter.filterPacket(packet);
        // the frame's pixel is left out
        assertEquals(List.of(packet.events.get(0), packet.events.get(1), packet.events.get(3)), filter.truthAsked);
    }

    @Test
    public void familyStartsWithoutWhatWouldSpoilIt() {
        SofasFlow filter = filter();
        assertFalse(filter.speedControlEnabled);
        assertFalse(filter.displayVectorsEnabled);
        assertFalse(filter.displayGlobalMotion);
        assertFalse(filter.measureAccuracy);
        // and takes what was chosen
        EventFilter.PREFERENCES.put("measureAccuracy", "true");
        EventFilter.PREFERENCES.put("displayGlobalMotion", "true");
        assertTrue(filter().measureAccuracy);
        assertTrue(filter().displayGlobalMotion);
    }

    private static Map<String, PropertyDescriptor> properties() throws IntrospectionException {
        BeanInfo info = Introspector.getBeanInfo(SofasFlow.class);
        Map<String, PropertyDescriptor> properties = new HashMap<>();
        for (PropertyDescriptor property : info.getPropertyDescriptors()) {
            if (property.getReadMethod() != null && property.getWriteMethod() != null) {
                properties.put(property.getName(), property);
            }
        }
        return properties;
    }

    @Test
    public void everyParameterIsAPropertyWithTheDefaultValueAndATooltip() throws Exception {
        SofasFlow filter = filter();
        for (ParameterHandle handle : ParameterHandle.all()) {
            String name = handle.name();
            PropertyDescriptor property = properties().get(name);
            assertTrue(name + " must be a property", property != null);
            Object value = property.getReadMethod().invoke(filter);
            Object expected = handle.get(SofasParameters.defaults());
            assertEquals(name, expected instanceof Double ? expected.toString() : String.valueOf(expected),
                value instanceof Float ? Double.valueOf(value.toString()).toString() : String.valueOf(value));
            assertTrue(name, filter.tooltips.containsKey(name));
        }
        assertEquals(SofasParameters.defaults(), filter.parameters());
    }

    @Test
    public void tooltipHasMeaningUnitRangeAndBothPresets() {
        assertEquals("<html>travel after which an event leaves a track plane<br>1 to 100 px; default 5, paper 3",
            filter().tooltips.get("lifetimePx"));
    }

    @Test
    public void everyOwnPropertyHasATooltip() throws Exception {
        SofasFlow filter = filter();
        for (PropertyDescriptor property : properties().values()) {
            if (property.getWriteMethod().getDeclaringClass().getName().startsWith("io.github.sofas")) {
                assertTrue(property.getName(), filter.tooltips.containsKey(property.getName()));
            }
        }
    }

    @Test
    public void simpleViewHasWhatToBeginWith() throws Exception {
        Set<String> simple = new TreeSet<>();
        for (PropertyDescriptor property : properties().values()) {
            if (property.getReadMethod().isAnnotationPresent(Preferred.class)) {
                simple.add(property.getName());
            }
        }
        assertEquals(new TreeSet<>(List.of("preset", "slowestPxPerS", "fastestPxPerS", "maxTrackPlanes", "minShare",
            "eventColours", "contoursShown", "segmentVelocityShown", "segmentLabelsShown", "metricShown",
            "legendShown")), simple);
    }

    @Test
    public void controlsForFlowOfSingleEventsAreHidden() {
        assertTrue(filter().hidden.containsAll(List.of("refractoryPeriodUs", "speedControlEnabled",
            "displayMotionField")));
    }

    @Test
    public void chooserFindsTheFilterByWhatItDoes() {
        String description = SofasFlow.class.getAnnotation(Description.class).value();
        for (String word : List.of("motion", "tracking", "velocity", "optical flow", "segmentation")) {
            assertTrue(word, description.contains(word));
        }
        assertTrue(SofasFlow.class.getAnnotation(Help.class).value().startsWith("<html>"));
    }

    @Test
    public void changesAreKeptForTheNextFilter() {
        SofasFlow filter = filter();
        filter.setPreset(Preset.PAPER);
        filter.setConstantEvents(200);
        filter.setMinShare(0.15f);
        filter.setRotation(false);
        filter.setLegendShown(false);
        filter.setEventColours(FlowDrawing.Colouring.FLOW);
        SofasFlow next = new SofasFlow(chip);
        assertEquals(SofasParameters.paper().with("constantEvents", 200).with("minShare", 0.15).with("rotation", false),
            next.parameters());
        assertFalse(next.isLegendShown());
        assertEquals(FlowDrawing.Colouring.FLOW, next.getEventColours());
    }

    @Test
    public void pairsOfParametersAreKeptWhicheverIsReadFirst() {
        SofasFlow filter = filter();
        filter.setMaxLifetimePx(40);
        filter.setLifetimePx(30);
        assertEquals(SofasParameters.defaults().with("maxLifetimePx", 40).with("lifetimePx", 30),
            new SofasFlow(chip).parameters());
        assertEquals(List.of(), warnings);
    }

    @Test
    public void unusablePreferencesAreMovedIntoTheirBounds() {
        EventFilter.PREFERENCES.put("preset", "BEST");
        EventFilter.PREFERENCES.put("minShare", "7");
        EventFilter.PREFERENCES.put("eventColours", "GREEN");
        SofasFlow filter = filter();
        assertEquals(SofasParameters.defaults().with("minShare", 1), filter.parameters());
        assertEquals(FlowDrawing.Colouring.SEGMENT, filter.getEventColours());
        assertEquals(List.of("preset must be DEFAULT or PAPER but was BEST; set to DEFAULT",
            "minShare must be between 0 and 1 but was 7; set to 1"), warnings);
    }

    @Test
    public void valueOutsideItsBoundsIsMovedAndSaid() {
        SofasFlow filter = filter();
        List<PropertyChangeEvent> changes = new ArrayList<>();
        filter.getSupport().addPropertyChangeListener(changes::add);
        filter.setMaxTrackPlanes(100);
        assertEquals(64, filter.getMaxTrackPlanes());
        filter.setLifetimePx(50);
        assertEquals(16, filter.getLifetimePx(), 0);
        filter.setSlowestPxPerS(Float.NaN);
        assertEquals(0.1f, filter.getSlowestPxPerS(), 0);
        assertEquals(List.of("maxTrackPlanes must be between 1 and 64 but was 100; set to 64",
            "lifetimePx must be between 1 and 16 but was 50; set to 16",
            "slowestPxPerS must be between 0.1 and 750 but was NaN; set to 0.1"), warnings);
        // the control that shows what was asked for is told what was taken
        assertEquals("maxTrackPlanes", changes.get(0).getPropertyName());
        assertEquals(100, changes.get(0).getOldValue());
        assertEquals(64, changes.get(0).getNewValue());
    }

    @Test
    public void controlIsToldAfterTheFieldIsSet() {
        SofasFlow filter = filter();
        List<Object> seen = new ArrayList<>();
        // a control sets what it is told, which must end there
        filter.getSupport().addPropertyChangeListener("minEvents", change -> {
            seen.add(filter.getMinEvents());
            filter.setMinEvents((Integer) change.getNewValue());
        });
        filter.setMinEvents(50);
        assertEquals(List.of(50), seen);
    }

    @Test
    public void presetTakesItsValuesToTheControls() {
        SofasFlow filter = filter();
        Map<String, Object> told = new HashMap<>();
        filter.getSupport().addPropertyChangeListener(change -> told.put(change.getPropertyName(),
            change.getNewValue()));
        filter.setPreset(Preset.PAPER);
        assertEquals(SofasParameters.paper(), filter.parameters());
        assertEquals(3f, told.get("lifetimePx"));
        assertEquals(200_000, told.get("lifespanUs"));
        assertEquals(0.2f, told.get("minShare"));
        assertFalse(told.containsKey("minEvents"));
    }

    @Test
    public void oneButtonBringsThePresetsValuesBack() {
        SofasFlow filter = filter();
        filter.setPreset(Preset.PAPER);
        filter.setConstantEvents(200);
        filter.setMinShare(0.15f);
        Map<String, Object> told = new HashMap<>();
        filter.getSupport().addPropertyChangeListener(change -> told.put(change.getPropertyName(),
            change.getNewValue()));
        filter.doSetDefaults();
        assertEquals(SofasParameters.paper(), filter.parameters());
        assertEquals(SofasParameters.paper(), new SofasFlow(chip).parameters());
        assertEquals(0.2f, told.get("minShare"));
        // nor does it switch on what is off at first
        assertFalse(filter.displayVectorsEnabled);
        assertFalse(filter.displayGlobalMotion);
    }

    @Test
    public void changedParameterTakesEffectWhileTracking() {
        SofasFlow filter = filter();
        show(filter);
        filter.setMaxTrackPlanes(1);
        filter.filterPacket(Packets.of(FILM.get(FILM.size() - 1)));
        int[] segments = filter.lastFlow().segment;
        int tracked = 0;
        for (int i = 0; i < filter.lastBatch().size(); i++) {
            if (segments[i] != 0) {
                assertTrue(tracked == 0 || tracked == segments[i]);
                tracked = segments[i];
            }
        }
    }

    @Test
    public void sliderEndsAreTheParametersBounds() throws Exception {
        SofasFlow filter = filter();
        int sliders = 0;
        for (ParameterHandle handle : ParameterHandle.all()) {
            String capital = Character.toUpperCase(handle.name().charAt(0)) + handle.name().substring(1);
            Method least;
            Method most;
            try {
                least = SofasFlow.class.getMethod("getMin" + capital);
                most = SofasFlow.class.getMethod("getMax" + capital);
            } catch (NoSuchMethodException e) {
                continue;
            }
            var bounds = handle.declaration();
            assertEquals(bounds.min(), ((Number) least.invoke(filter)).doubleValue(), 1e-6);
            assertEquals(bounds.max(), ((Number) most.invoke(filter)).doubleValue(), 1e-6);
            sliders++;
        }
        assertEquals(5, sliders);
    }

    /** Any value by any thread, at any time. */
    @Test
    public void settersNeverThrowAndNeverWaitForThePacket() throws Exception {
        SofasFlow filter = filter();
        AtomicReference<Throwable> thrown = new AtomicReference<>();
        Thread viewer = new Thread(() -> {
            for (int i = 0; i < 3; i++) {
                show(filter);
                filter.good.clear();
                filter.resetFilter();
            }
        });
        viewer.setUncaughtExceptionHandler((thread, e) -> thrown.set(e));
        viewer.start();
        Random random = new Random(3);
        double[] values = {Double.NaN, Double.POSITIVE_INFINITY, -1, 0, 0.01, 0.5, 1, 3, 12, 900, 1e5};
        List<PropertyDescriptor> properties = new ArrayList<>(properties().values());
        for (int i = 0; viewer.isAlive(); i++) {
            PropertyDescriptor property = properties.get(random.nextInt(properties.size()));
            if (!property.getWriteMethod().getDeclaringClass().getName().startsWith("io.github.sofas")) {
                continue;
            }
            Class<?> type = property.getPropertyType();
            double value = values[random.nextInt(values.length)];
            Object argument = type == boolean.class ? (Object) random.nextBoolean()
                : type == int.class ? (Object) (int) value : type == float.class ? (Object) (float) value
                : type.getEnumConstants()[random.nextInt(10) == 0 ? 0 : 1];
            property.getWriteMethod().invoke(filter, argument);
            Thread.sleep(i % 10 == 0 ? 1 : 0);
        }
        assertNull(thrown.get());
    }

    @Test
    public void settersReturnWhileAPacketIsFiltered() throws Exception {
        SofasFlow filter = filter();
        Thread setter = new Thread(() -> filter.setMinEvents(60));
        synchronized (filter) {
            setter.start();
            setter.join(10_000);
            assertFalse(setter.isAlive());
        }
        assertEquals(60, filter.getMinEvents());
    }
}
