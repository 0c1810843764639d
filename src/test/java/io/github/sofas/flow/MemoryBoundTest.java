package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.smooth.Smoother;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.Test;

/** What an engine holds, measured by following all of its references, against the bound that it states. */
public class MemoryBoundTest {
    private static final SensorSize SENSOR = new SensorSize(240, 180);

    /** Bytes of all arrays that can be reached, and 16 for each object. */
    private static long measured(Object root) throws ReflectiveOperationException {
        Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        Deque<Object> open = new ArrayDeque<>(List.of(root));
        long bytes = 0;
        while (!open.isEmpty()) {
            Object object = open.pop();
            if (!seen.add(object)) {
                continue;
            }
            bytes += 16;
            Class<?> type = object.getClass();
            if (type.isArray()) {
                bytes += Array.getLength(object) * size(type.getComponentType());
                if (!type.getComponentType().isPrimitive()) {
                    for (Object element : (Object[]) object) {
                        push(open, element);
                    }
                }
            } else if (object instanceof List<?> list) {
                list.forEach(element -> push(open, element));
            } else if (object instanceof Map<?, ?> map) {
                map.values().forEach(element -> push(open, element));
            } else if (type.getName().startsWith("io.github.sofas.")) {
                for (Field field : type.getDeclaredFields()) {
                    bytes += 8;
                    if (!Modifier.isStatic(field.getModifiers()) && !field.getType().isPrimitive()
                            && !type.isHidden()) {
                        field.setAccessible(true);
                        push(open, field.get(object));
                    }
                }
            }
        }
        return bytes;
    }

    private static void push(Deque<Object> open, Object object) {
        if (object != null) {
            open.push(object);
        }
    }

    private static long size(Class<?> component) {
        if (component == long.class || component == double.class) {
            return 8;
        } else if (component == int.class || component == float.class) {
            return 4;
        } else if (component == short.class || component == char.class) {
            return 2;
        }
        return component.isPrimitive() ? 1 : 8;
    }

    private static Sofas engineAfter(EventBatch events, SensorSize sensor, SofasParameters p) {
        Sofas sofas = new Sofas(sensor, p);
        sofas.process(events, new FlowOutput(events.size()));
        return sofas;
    }

    @Test
    public void noEventsMakeAnEngineHoldMoreThanItStates() throws Exception {
        SensorSize small = new SensorSize(64, 48);
        for (SofasParameters p : List.of(SofasParameters.defaults(), SofasParameters.paper())) {
            for (EventBatch stream : HostileStreams.all(small, 20_000).values()) {
                long held = measured(engineAfter(stream, small, p));
                long most = Sofas.mostBytes(small, p);
                assertTrue(p.preset() + " holds " + held + " of " + most, held <= most);
            }
        }
    }

    @Test
    public void millionsOfEventsThatNothingTracksAreHeldUpToTheBound() throws Exception {
        EventBatch noise = new EventBatch(1_300_000);
        Random random = new Random(1);
        for (int i = 0; i < noise.capacity(); i++) {
            noise.add(i, random.nextInt(240), random.nextInt(180), random.nextInt(2));
        }
        SofasParameters p = SofasParameters.defaults();
        long held = measured(engineAfter(noise, SENSOR, p));
        long most = Sofas.mostBytes(SENSOR, p);
        assertTrue("holds " + held + " of " + most, held <= most);
        // the flow plane's ring of 2^20 events is full, and did not grow beyond
        assertTrue("holds " + held, held >= (1 << 20) * 17L);
    }

    @Test
    public void lookAheadHoldsAtMostSixtyFourMegabytesMore() throws Exception {
        SensorSize sensor = new SensorSize(346, 260);
        long most = Smoother.mostBytes(sensor);
        assertTrue(most + " bytes", most <= 64L << 20);
        SofasParameters p = SofasParameters.defaults();
        assertEquals(Sofas.mostBytes(sensor, p) + most, SmoothedSofas.mostBytes(sensor, p));
        // 20 events in a us, in slices of 2^16 that are given back one by one
        Smoother smoother = new Smoother(sensor, p.track(), SmoothedSofas.MAX_LOOK_AHEAD_US);
        EventBatch event = new EventBatch(1);
        FlowOutput flow = new FlowOutput(4096);
        EventBatch taken = new EventBatch(4096);
        Motion motion = new Motion();
        Random random = new Random(1);
        for (int i = 0; i < 1_000_000; i++) {
            int x = random.nextInt(346);
            int y = random.nextInt(260);
            event.clear();
            event.add(i / 20, x, y, random.nextInt(2));
            if (i % 25 == 0) {
                motion.set(i / 20, random.nextInt(100), 0);
                smoother.add(1 + i / 25 % 63, motion);
            }
            smoother.endSlices(i / 20);
            while (smoother.take(taken, flow)) {
                assertTrue(taken.size() > 0);
            }
            // side by side, each a part of 44 x 33 px: who shares its place competes for events, which takes long
            flow.segment[0] = x / 44 + y / 33 * 8;
            smoother.add(event, flow, 0);
        }
        long held = measured(smoother);
        assertTrue("holds " + held + " of " + most, held <= most);
        assertTrue("holds " + held, held > (1 << 20) * 37L);
    }

    @Test
    public void boundIsNotFarAboveWhatIsHeld() throws Exception {
        for (SofasParameters preset : List.of(SofasParameters.defaults(), SofasParameters.paper())) {
            SofasParameters p = preset.with("maxTrackPlanes", 1);
            long held = measured(new Sofas(SENSOR, p));
            long most = Sofas.mostBytes(SENSOR, p);
            long events = p.preset() == SofasParameters.Preset.DEFAULT ? 52_000_000 : 30_000_000;
            assertTrue(p.preset() + " holds " + held + " of " + most, most <= held + events);
        }
    }
}
