package io.github.sofas.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Finds the parts of a recording that are worth a picture: its busiest moments, and the seconds with the greatest
 * number of events with flow, for a clip. Sees each event once and holds no events.
 */
final class Highlights {
    /** Pictures per second of the clip. */
    static final int FPS = 30;
    /** Duration of a step, µs: time is divided into steps of one picture. */
    static final long STEP_US = 1_000_000 / FPS;
    static final int CLIP_S = 10;
    static final int CLIP_STEPS = CLIP_S * FPS;
    static final int MOMENTS = 6;
    /** Moments closer together than this number of steps count as one: only the busiest is kept. */
    static final int APART_STEPS = 10;

    private long step;
    private long events;
    private long withFlow;

    /** Events with flow in each of the last {@link #CLIP_STEPS} steps, and in all of these steps together. */
    private final long[] lately = new long[CLIP_STEPS];
    private long latelyAll;
    private long best;
    private long bestFirst;
    private final List<Moment> moments = new ArrayList<>();

    /**
     * A busy step.
     *
     * @param step counted from the first event
     * @param events in it
     */
    record Moment(long step, long events) {
    }

    /** Takes an event by its time since the first one. Times must not decrease. */
    void add(long sinceFirstUs, boolean hasFlow) {
        long newStep = sinceFirstUs / STEP_US;
        if (newStep > step) {
            end();
            long quiet = Math.min(newStep - step - 1, CLIP_STEPS);
            for (long each = newStep - quiet; each < newStep; each++) {
                put(each, 0);
            }
            step = newStep;
        }
        events++;
        withFlow += hasFlow ? 1 : 0;
    }

    /** Ends the search, after the last event. */
    void finish() {
        end();
        moments.sort(Comparator.comparingLong(Moment::step));
    }

    private void end() {
        put(step, withFlow);
        if (latelyAll > best) {
            best = latelyAll;
            bestFirst = firstWithFlow();
        }
        keepIfBusy();
        events = 0;
        withFlow = 0;
    }

    /**
     * The first of the last steps, after the leading ones that together hold less than a hundredth of the events with
     * flow.
     */
    private long firstWithFlow() {
        long first = Math.max(0, step + 1 - CLIP_STEPS);
        long left = 0;
        while ((left + lately[(int) (first % CLIP_STEPS)]) * 100 < latelyAll) {
            left += lately[(int) (first % CLIP_STEPS)];
            first++;
        }
        return first;
    }

    private void put(long at, long count) {
        int place = (int) (at % CLIP_STEPS);
        latelyAll += count - lately[place];
        lately[place] = count;
    }

    private void keepIfBusy() {
        List<Moment> close = new ArrayList<>();
        Moment least = null;
        for (Moment each : moments) {
            if (step - each.step < APART_STEPS) {
                close.add(each);
            }
            if (least == null || each.events < least.events) {
                least = each;
            }
        }
        if (events == 0 || close.stream().anyMatch(each -> each.events >= events)) {
            return;
        }
        if (close.isEmpty() && moments.size() == MOMENTS) {
            if (least.events >= events) {
                return;
            }
            moments.remove(least);
        }
        moments.removeAll(close);
        moments.add(new Moment(step, events));
    }

    /**
     * The first step of the clip, valid once finished. Something moves in the clip if anything moves in the recording.
     */
    long clipFirst() {
        return Math.max(0, Math.min(bestFirst, step + 1 - CLIP_STEPS));
    }

    /** The step after the clip. */
    long clipEnd() {
        return Math.min(clipFirst() + CLIP_STEPS, step + 1);
    }

    boolean clipIsAll() {
        return clipFirst() == 0 && clipEnd() == step + 1;
    }

    /** The busiest moments in order of time, valid once finished. */
    List<Moment> moments() {
        return List.copyOf(moments);
    }
}
