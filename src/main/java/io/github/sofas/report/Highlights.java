package io.github.sofas.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Finds what of a recording is worth a picture: busy moments, and the seconds in which most events have flow. */
final class Highlights {
    /** Pictures per second of the clip. */
    static final int FPS = 30;
    /** Time is looked at in steps of one picture. */
    static final long STEP_US = 1_000_000 / FPS;
    static final int CLIP_S = 10;
    static final int CLIP_STEPS = CLIP_S * FPS;
    static final int MOMENTS = 6;
    /** Of moments that are closer than these steps only the busiest counts. */
    static final int APART_STEPS = 10;

    private long step;
    private long events;
    private long withFlow;

    /** Events with flow in each of the last steps, and in all of them. */
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

    /** Takes an event, by its time since the first one; times do not go back. */
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

    /** After the last event. */
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

    /** The first of the last steps but for those at their beginning that hold less than a hundredth of the events. */
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

    /** The first step of the clip, which something moves in where it does anywhere; once finished. */
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

    /** In order of time; once finished. */
    List<Moment> moments() {
        return List.copyOf(moments);
    }
}
