package io.github.sofas.flow;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertTrue;

import com.sun.management.ThreadMXBean;
import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

/** Nothing is allocated per event: what a structure needs is allocated when it begins or ends, and is used again. */
public class SofasAllocationTest {
    private static final SensorSize SENSOR = new SensorSize(240, 180);
    private static final int BATCH = 500;

    @Test
    public void paperPresetAllocatesNothingInSteadyState() {
        assertAllocatesNothing(SofasParameters.paper());
    }

    @Test
    public void defaultPresetAllocatesNothingInSteadyState() {
        assertAllocatesNothing(SofasParameters.defaults());
    }

    /**
     * Shows one film again and again: first all arrays grow to their size and the code is compiled. Of the later
     * showings the least of each batch counts, since a virtual machine may allocate a little for itself at any time.
     * Batches in which a track plane begins or ends are left out.
     */
    private static void assertAllocatesNothing(SofasParameters p) {
        if (!(ManagementFactory.getThreadMXBean() instanceof ThreadMXBean)) {
            throw Skipped.because("this Java does not count what a thread allocates");
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long thread = Thread.currentThread().getId();
        List<Event> film = Streams.filmed(Scene.HEXAGON, SENSOR, 1, 15, 40_000);
        List<EventBatch> batches = new ArrayList<>();
        for (int i = 0; i + BATCH <= film.size(); i += BATCH) {
            batches.add(Streams.batch(film.subList(i, i + BATCH)));
        }
        int[] ended = new int[1];
        Sofas sofas = new Sofas(SENSOR, p, segment -> ended[0]++);
        FlowOutput output = new FlowOutput(BATCH);
        long[] least = new long[batches.size()];
        Arrays.fill(least, Long.MAX_VALUE);
        int steady = 0;
        for (int showing = 0; showing < 5; showing++) {
            sofas.reset();
            steady = 0;
            int living = 0;
            for (int i = 0; i < batches.size(); i++) {
                ended[0] = 0;
                long before = threads.getThreadAllocatedBytes(thread);
                sofas.process(batches.get(i), output);
                long allocated = threads.getThreadAllocatedBytes(thread) - before;
                int now = sofas.segments().size();
                if (ended[0] > 0 || now != living) {
                    least[i] = 0;
                } else if (showing >= 2) {
                    least[i] = Math.min(least[i], allocated);
                    steady += now > 0 ? 1 : 0;
                }
                living = now;
            }
        }
        assertArrayEquals("bytes allocated per batch", new long[least.length], least);
        assertTrue("steady batches with a track plane: " + steady, steady > batches.size() / 2);
    }
}
