package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.util.Arrays;

/**
 * Puts the times of a recording's events in order, for every format.
 *
 * <p>A time that advances by more than {@value #JUMP_US} µs, or falls by more than {@value #FAR_US} µs, is a jump. A
 * jump is believed where the following events continue from it: after a pause, or where a clock was set back. Where
 * they do not, only this one event is damaged, not all that follow, and it is dropped. A shorter step back is that of a
 * single event; such an event gets the greatest time before it.
 */
final class TimeOrder {
    /**
     * Advances up to this, in µs, are not checked: nothing is gained where a damaged time moved no later event by more.
     */
    static final long JUMP_US = 10_000;
    /** Larger steps back, in µs, come from the clock or from damage. */
    static final long FAR_US = 1_000_000;
    /**
     * Largest time, in µs. Beyond it (31,700 years, 18 digits) no clock is right, and sums of times overflow 64 bits.
     */
    static final long MOST_US = 999_999_999_999_999_999L;

    /** Number of following events that decide whether a jump is real. */
    private static final int WITNESSES = 8;
    /**
     * The same for a jump of more than {@link #FAR_US}: a packet may hold thousands of events with one damaged time.
     */
    private static final int MANY_WITNESSES = 4096;
    /** Fewer witnesses than this cannot show which event is damaged. */
    private static final int FEWEST_WITNESSES = 4;
    /** One in this number of witnesses may be damaged itself. */
    private static final int DAMAGED_SHARE = 4;
    /** A first or last event is this far from the others, in µs, only where its time is damaged. */
    private static final long ALONE_US = 60_000_000;
    private static final int ALONE_FACTOR = 100;

    private final RecordingReader reader;
    private final TimeFaults faults;

    /** Time of the last event that was in order, as the file holds it and as it is delivered. */
    private long fileUs;
    private long timeUs;
    private long firstUs;
    private boolean started;
    private long inOrder;

    /** Events whose place in the order is not known yet, from index {@code at} on. */
    private long[] waitingUs = new long[0];
    private short[] waitingX = new short[0];
    private short[] waitingY = new short[0];
    private byte[] waitingPolarity = new byte[0];
    private long[] waitingNumber = new long[0];
    private long[] waitingPlace = new long[0];
    private int at;
    private int end;

    TimeOrder(RecordingReader reader, TimeFaults faults) {
        this.reader = reader;
        this.faults = faults;
    }

    /** How many events wait for those that follow. */
    int waiting() {
        return end - at;
    }

    /** Forgets the waiting events. */
    void end() {
        at = 0;
        end = 0;
    }

    /** Time of the last event in order; 0 before the first. */
    long lastUs() {
        return timeUs;
    }

    /** Time of the first event; 0 before it. */
    long firstUs() {
        return firstUs;
    }

    /** Converts a time of the file to the clock of the delivered events. */
    long timeOf(long otherFileUs) {
        return started ? timeUs + reader.step(fileUs, otherFileUs) : otherFileUs;
    }

    /**
     * Sets the times of the events of a freshly decoded batch, up to the first event that does not simply come next.
     * That event and those after it wait.
     */
    void takeRegular(EventBatch batch, long[] numbers, long[] places) {
        long[] times = batch.timeUs;
        int n = batch.size();
        int regular = 0;
        if (started && waiting() == 0) {
            long last = fileUs;
            while (regular < n && times[regular] - last >= 0 && times[regular] - last <= JUMP_US) {
                last = times[regular++];
            }
            long shift = timeUs - fileUs;
            if (shift != 0) {
                for (int i = 0; i < regular; i++) {
                    times[i] += shift;
                }
            }
            fileUs = last;
            timeUs = last + shift;
            inOrder += regular;
        }
        if (regular < n) {
            addWaiting(batch, regular, n, numbers, places);
            batch.setSize(regular);
        }
    }

    private void addWaiting(EventBatch batch, int from, int to, long[] numbers, long[] places) {
        int count = to - from;
        if (end + count > waitingUs.length) {
            int left = end - at;
            int room = Math.max(2 * (left + count), MANY_WITNESSES);
            waitingUs = Arrays.copyOf(Arrays.copyOfRange(waitingUs, at, end), room);
            waitingX = Arrays.copyOf(Arrays.copyOfRange(waitingX, at, end), room);
            waitingY = Arrays.copyOf(Arrays.copyOfRange(waitingY, at, end), room);
            waitingPolarity = Arrays.copyOf(Arrays.copyOfRange(waitingPolarity, at, end), room);
            waitingNumber = Arrays.copyOf(Arrays.copyOfRange(waitingNumber, at, end), room);
            waitingPlace = Arrays.copyOf(Arrays.copyOfRange(waitingPlace, at, end), room);
            at = 0;
            end = left;
        }
        System.arraycopy(batch.timeUs, from, waitingUs, end, count);
        System.arraycopy(batch.x, from, waitingX, end, count);
        System.arraycopy(batch.y, from, waitingY, end, count);
        System.arraycopy(batch.polarity, from, waitingPolarity, end, count);
        System.arraycopy(numbers, from, waitingNumber, end, count);
        System.arraycopy(places, from, waitingPlace, end, count);
        end += count;
    }

    /**
     * Appends waiting events to a batch, until the batch is full or an event needs more events after it.
     *
     * @param last whether no more events follow the waiting ones
     * @throws MalformedRecordingException at a time out of order where the reading is strict
     */
    void putWaiting(EventBatch batch, boolean last) throws MalformedRecordingException {
        while (at < end && !batch.isFull()) {
            long candidateUs = waitingUs[at];
            long step = started ? reader.step(fileUs, candidateUs) : 0;
            boolean falls = step < -FAR_US;
            if (candidateUs > MOST_US || candidateUs < -MOST_US) {
                faults.damaged(candidateUs, waitingNumber[at], waitingPlace[at]);
                at++;
            } else if (started && step >= -FAR_US && step <= JUMP_US) {
                put(batch, step);
            } else {
                int wanted = started && !falls && step <= FAR_US ? WITNESSES : MANY_WITNESSES;
                int witnesses = Math.min(wanted, end - at - 1);
                if (witnesses < wanted && !last) {
                    return;
                }
                if (!isConfirmed(step, witnesses)) {
                    faults.damaged(timeOf(candidateUs), waitingNumber[at], waitingPlace[at]);
                    at++;
                } else if (falls) {
                    faults.restarts(timeOf(candidateUs), waitingNumber[at], waitingPlace[at]);
                    fileUs = candidateUs;
                    put(batch, 0);
                } else {
                    put(batch, step);
                }
            }
        }
        if (at == end) {
            end();
        }
    }

    private void put(EventBatch batch, long step) throws MalformedRecordingException {
        long candidateUs = waitingUs[at];
        if (step < 0) {
            faults.stepBack(timeUs + step, waitingNumber[at], waitingPlace[at]);
        } else {
            if (!started) {
                started = true;
                timeUs = candidateUs;
                firstUs = candidateUs;
            } else {
                if (step != candidateUs - fileUs) {
                    faults.wrapped();
                }
                timeUs += step;
            }
            fileUs = candidateUs;
        }
        inOrder++;
        batch.add(timeUs, waitingX[at], waitingY[at], waitingPolarity[at]);
        at++;
    }

    /** Whether the following events continue from the event at {@code at}, not from the events before it. */
    private boolean isConfirmed(long step, int witnesses) {
        if (witnesses == 0) {
            boolean isAlone = started && step > ALONE_US && step > timeUs - firstUs && inOrder >= ALONE_FACTOR;
            return step >= 0 && !isAlone;
        }
        if (!started && witnesses < FEWEST_WITNESSES) {
            return true;
        }
        long candidateUs = waitingUs[at];
        if (!started && witnesses >= WITNESSES) {
            long gap = reader.step(candidateUs, waitingUs[at + 1]);
            long span = reader.step(waitingUs[at + 1], waitingUs[at + WITNESSES]);
            if (gap > ALONE_US && span >= 0 && span < gap / ALONE_FACTOR) {
                return false;
            }
        }
        int against = 0;
        int most = witnesses / (witnesses < FEWEST_WITNESSES ? 2 : DAMAGED_SHARE);
        for (int i = at + 1; i <= at + witnesses && against <= most; i++) {
            long fromCandidate = reader.step(candidateUs, waitingUs[i]);
            long fromBefore = started ? reader.step(fileUs, waitingUs[i]) : fromCandidate;
            boolean goesOnAsBefore = !started ? fromCandidate < -JUMP_US
                : step > 0 ? fromBefore >= -FAR_US && fromBefore < step - JUMP_US : fromBefore >= -FAR_US;
            if (goesOnAsBefore || reader.step(waitingUs[i - 1], waitingUs[i]) < -JUMP_US) {
                against++;
            }
        }
        return against <= most;
    }
}
