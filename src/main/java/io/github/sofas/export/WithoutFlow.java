package io.github.sofas.export;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;
import java.util.Locale;

/**
 * Finds out why most events of a recording found no flow, as far as the events show it. Three properties are checked
 * for each event without flow. The likely reason is the first of these that more than half of the events without flow
 * have:
 * <ul>
 * <li>flicker: at the event's pixel, light rose and fell twice in a row, in equal times of less than
 * {@value #LONGEST_FLICKER_US} µs;
 * <li>few pixels: the event comes from one of the pixels that fire most, a thousandth of the sensor;
 * <li>noise: neither the event's pixel nor one of the eight around it fired within the {@value #COMPANY_US} µs before.
 * </ul>
 * If there is none, a recording shorter than {@value #SHORT_US} µs is too short. In any other recording, the motion is
 * too small, too rare or too irregular.
 */
public final class WithoutFlow {
    private static final int LONGEST_FLICKER_US = 30_000;
    private static final int SHORTEST_FLICKER_US = 500;
    private static final int COMPANY_US = 10_000;
    private static final long SHORT_US = 100_000;
    private static final double MOST = 0.5;
    private static final double EQUAL_TIMES = 0.25;
    private static final double FEW_PIXELS = 0.001;
    private static final int NEVER = Integer.MIN_VALUE;

    private final int width;
    private final int height;
    /**
     * Time of each pixel's last event in µs from the first event, as a whole number that wraps; {@link #NEVER} if there
     * is none.
     */
    private final int[] lastUs;
    /** Per pixel and polarity, time at which the newest run of events of that polarity began. */
    private final int[] runUs;
    /** Per pixel, time between the beginnings of the last two runs of one polarity; 0 if not known. */
    private final int[] periodUs;
    private final byte[] polarity;
    private final boolean[] regular;
    private final int[] unlabelledAt;
    private boolean begun;
    private long firstUs;
    private long newestUs;
    private long events;
    private long unlabelled;
    private long flickering;
    private long alone;

    /**
     * Starts without events.
     *
     * @param sensor size of the sensor
     */
    public WithoutFlow(SensorSize sensor) {
        width = sensor.width();
        height = sensor.height();
        int pixels = width * height;
        lastUs = new int[pixels];
        runUs = new int[2 * pixels];
        periodUs = new int[pixels];
        polarity = new byte[pixels];
        regular = new boolean[pixels];
        unlabelledAt = new int[pixels];
        Arrays.fill(lastUs, NEVER);
        Arrays.fill(runUs, NEVER);
    }

    /**
     * Adds a labelled batch. Batches must come in order.
     *
     * @param batch the events
     * @param flow their labels
     */
    public void add(EventBatch batch, FlowOutput flow) {
        for (int i = 0; i < batch.size(); i++) {
            if (!begun) {
                begun = true;
                firstUs = batch.timeUs[i];
            }
            newestUs = batch.timeUs[i];
            int x = batch.x[i];
            int y = batch.y[i];
            if (x < 0 || x >= width || y < 0 || y >= height) {
                continue;
            }
            int pixel = y * width + x;
            int nowUs = (int) (newestUs - firstUs);
            follow(pixel, batch.polarity[i], nowUs);
            events++;
            if (flow.segment[i] == 0) {
                unlabelled++;
                unlabelledAt[pixel]++;
                flickering += regular[pixel] ? 1 : 0;
                alone += isAlone(x, y, nowUs) ? 1 : 0;
            }
            lastUs[pixel] = nowUs;
        }
    }

    /** Updates the time that light at a pixel takes from rise to rise and from fall to fall. */
    private void follow(int pixel, byte sign, int nowUs) {
        if (sign == polarity[pixel]) {
            return;
        }
        polarity[pixel] = sign;
        int run = 2 * pixel + (sign > 0 ? 1 : 0);
        int period = runUs[run] == NEVER ? 0 : nowUs - runUs[run];
        int before = periodUs[pixel];
        regular[pixel] = period >= SHORTEST_FLICKER_US && period < LONGEST_FLICKER_US
            && Math.abs(period - before) <= EQUAL_TIMES * period;
        periodUs[pixel] = period;
        runUs[run] = nowUs;
    }

    private boolean isAlone(int x, int y, int nowUs) {
        for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
            for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
                int last = lastUs[row * width + column];
                if (last != NEVER && nowUs - last <= COMPANY_US) {
                    return false;
                }
            }
        }
        return true;
    }

    /** {@return the likely reason in words; empty if at least half of the events have flow} */
    public String likelyReason() {
        if (unlabelled <= MOST * events) {
            return "";
        }
        if (flickering > MOST * unlabelled) {
            return percent(flickering) + " of these repeat at their pixel at equal intervals: flickering light";
        }
        int[] busiest = unlabelledAt.clone();
        Arrays.sort(busiest);
        int few = (int) Math.ceil(FEW_PIXELS * busiest.length);
        long fromFew = 0;
        for (int i = 0; i < few; i++) {
            fromFew += busiest[busiest.length - 1 - i];
        }
        if (fromFew > MOST * unlabelled) {
            return percent(fromFew) + " of these come from " + few + (few == 1 ? " pixel" : " pixels")
                + ": hot pixels, or something that does not move";
        }
        if (alone > MOST * unlabelled) {
            return percent(alone) + " of these have no neighbouring event in the " + COMPANY_US / 1000
                + " ms before: noise, or too sparse";
        }
        if (newestUs - firstUs < SHORT_US) {
            return String.format(Locale.ROOT, "a recording of %.0f ms is too short to find a motion",
                (newestUs - firstUs) * 1e-3);
        }
        return "the motion is too short or too irregular to be distinguished from standstill";
    }

    private String percent(long count) {
        return String.format(Locale.ROOT, "%.0f %%", 100.0 * count / unlabelled);
    }
}
