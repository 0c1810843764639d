package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventprocessing.EventFilter;
import org.junit.Before;
import org.junit.Test;

/** An engine that takes long is played by its lock, which the test holds. */
public class EngineTest {
    private static final List<EventBatch> FILM = Packets.film();

    private final Engine engine = new Engine(Packets.SENSOR, SofasParameters.defaults(), ended -> { },
        labelled -> { });
    private SofasFlow filter;

    @Before
    public void prepare() {
        EventFilter.PREFERENCES.clear();
        AEChip chip = new AEChip();
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        filter = new SofasFlow(chip);
        filter.initFilter();
        filter.setFilterEnabled(true);
    }

    private LabelledPacket submit() {
        LabelledPacket packet = engine.take();
        engine.submit(packet);
        return packet;
    }

    @Test
    public void packetThatTakesLongDoesNotStopTheViewer() {
        synchronized (engine.sofas()) {
            submit();
            assertNull(engine.next(false));
            submit();
            assertNull(engine.next(false));
            assertEquals(2, engine.behind());
        }
    }

    @Test
    public void viewerWaitsWhereMoreThanTwoAreBehind() throws InterruptedException {
        Thread viewer;
        List<LabelledPacket> handedOut = new ArrayList<>();
        LabelledPacket first;
        synchronized (engine.sofas()) {
            first = submit();
            submit();
            submit();
            viewer = new Thread(() -> handedOut.add(engine.next(false)));
            viewer.start();
            viewer.join(200);
            assertTrue(viewer.isAlive());
        }
        viewer.join(10_000);
        assertSame(first, handedOut.get(0));
    }

    @Test
    public void packetsAreHandedOutInOrder() {
        List<LabelledPacket> submitted = List.of(submit(), submit(), submit());
        List<LabelledPacket> handedOut = new ArrayList<>();
        for (LabelledPacket packet = engine.next(true); packet != null; packet = engine.next(true)) {
            handedOut.add(packet);
        }
        assertEquals(submitted, handedOut);
        assertEquals(0, engine.behind());
    }

    @Test
    public void packetsOnTheirWayAreForgottenByAReset() {
        submit();
        submit();
        engine.reset();
        assertNull(engine.next(true));
    }

    @Test
    public void resultsAreThoseOfAnEngineThatIsAwaited() {
        List<String> late = show(false);
        filter.resetFilter();
        assertTrue(late.equals(show(true)));
    }

    private List<String> show(boolean awaited) {
        filter.good.clear();
        filter.setEngineAwaited(awaited);
        for (EventBatch batch : FILM) {
            filter.filterPacket(Packets.of(batch));
        }
        // the packets that are on their way come with the next, which is empty
        filter.finish();
        filter.filterPacket(Packets.of());
        return List.copyOf(filter.good);
    }

    @Test
    public void flowForOtherFiltersAndForMeasuringIsThatOfThePacket() {
        filter.displayRawInput = false;
        assertTogether();
        filter.displayRawInput = true;
        filter.measureProcessingTime = true;
        assertTogether();
        filter.measureProcessingTime = false;
        filter.measureAccuracy = true;
        assertTogether();
    }

    private void assertTogether() {
        filter.resetFilter();
        filter.good.clear();
        filter.filterPacket(Packets.of(FILM.get(0)));
        assertEquals(FILM.get(0).size(), filter.good.size());
        assertFalse(filter.lastBatch().size() == 0);
    }
}
