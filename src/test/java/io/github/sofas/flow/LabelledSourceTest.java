package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import org.junit.Test;

public class LabelledSourceTest {
    private static final SensorSize SENSOR = new SensorSize(16, 16);

    /** So many events, a millisecond apart, ten a batch; then damage or the end. */
    private static EventSource source(int events, boolean damaged) {
        return new EventSource() {
            private int next;

            @Override
            public SensorSize sensor() {
                return SENSOR;
            }

            @Override
            public boolean next(EventBatch batch) throws EventSourceException {
                batch.clear();
                for (int i = 0; i < 10 && next < events; i++, next++) {
                    batch.add(1000L * next, next % 16, next / 16 % 16, 1);
                }
                if (batch.size() == 0 && damaged) {
                    throw new EventSourceException("[x] damaged");
                }
                return batch.size() > 0;
            }

            @Override
            public void close() {
                // holds nothing
            }
        };
    }

    private static SmoothedSofas lookingAhead() {
        return new SmoothedSofas(SENSOR, SofasParameters.defaults(), 100_000);
    }

    @Test
    public void allEventsBeforeTheDamageComeFirst() throws EventSourceException {
        for (Labelling labelling : new Labelling[] {
            lookingAhead(), Labelling.atOnce(new Sofas(SENSOR, SofasParameters.defaults()))}) {
            LabelledSource labelled = new LabelledSource(source(995, true), labelling);
            EventBatch batch = new EventBatch(7);
            FlowOutput flow = new FlowOutput(7);
            for (int event = 0; event < 995;) {
                labelled.next(batch, flow);
                for (int i = 0; i < batch.size(); i++, event++) {
                    assertEquals(1000L * event, batch.timeUs[i]);
                }
            }
            assertEquals("[x] damaged",
                assertThrows(EventSourceException.class, () -> labelled.next(batch, flow)).getMessage());
        }
    }

    @Test
    public void endsWithTheSource() throws EventSourceException {
        LabelledSource labelled = new LabelledSource(source(0, false), lookingAhead());
        EventBatch batch = new EventBatch(7);
        FlowOutput flow = new FlowOutput(7);
        assertFalse(labelled.next(batch, flow));
        assertFalse(labelled.next(batch, flow));
    }

    @Test
    public void labelsAtOnceAreThoseOfTheMethod() {
        // handed in in pieces that do not fit what they are taken in
        Labelling labelling = Labelling.atOnce(new EventLabeller() {
            @Override
            public void process(EventBatch batch, FlowOutput output) {
                for (int i = 0; i < batch.size(); i++) {
                    output.set(i, (int) batch.timeUs[i] + 1, batch.x[i], 0);
                }
            }

            @Override
            public void reset() {
                throw new AssertionError();
            }
        });
        EventBatch in = new EventBatch(5000);
        EventBatch out = new EventBatch(3);
        FlowOutput flow = new FlowOutput(3);
        int handed = 0;
        int taken = 0;
        for (int size : new int[] {1, 2, 5000, 1, 100}) {
            in.clear();
            for (int i = 0; i < size; i++) {
                in.add(handed++, 1, 1, 1);
            }
            labelling.add(in);
            for (int k = 0; k < 2 && labelling.next(out, flow); k++) {
                for (int i = 0; i < out.size(); i++) {
                    assertEquals(taken, out.timeUs[i]);
                    assertEquals(++taken, flow.segment[i]);
                }
            }
        }
        while (labelling.next(out, flow)) {
            taken += out.size();
        }
        assertEquals(handed, taken);
    }
}
