package io.github.sofas.live;

/**
 * The time of a camera that sends its low bits with the events and a wrap each time that they overflow. Counted on in
 * 64 bits, in µs. The times it gives never fall: a camera that sets its time to zero goes on from the newest time, and
 * any other step back is counted and gets the newest time.
 */
final class CameraClock {
    private final long wrapWorthUs;
    /** When the camera's time was zero. */
    private long originUs;
    private long wrapUs;
    private long newestUs;
    private boolean wrapMayBeLost;

    long wraps;
    long resets;
    long stepsBack;

    /**
     * Starts at 0.
     *
     * @param wrapWorthUs what the low bits count up to before they start again
     */
    CameraClock(long wrapWorthUs) {
        this.wrapWorthUs = wrapWorthUs;
    }

    long newestUs() {
        return newestUs;
    }

    /** Takes the low bits of a time and gives the time. */
    long tell(int lowBits) {
        long timeUs = originUs + wrapUs + lowBits;
        if (timeUs < newestUs) {
            if (wrapMayBeLost) {
                wrap(1);
                timeUs += wrapWorthUs;
            } else {
                stepsBack++;
            }
            timeUs = Math.max(timeUs, newestUs);
        }
        wrapMayBeLost = false;
        newestUs = timeUs;
        return timeUs;
    }

    /** The low bits have overflowed so many times. */
    void wrap(int times) {
        wraps += times;
        wrapUs += times * wrapWorthUs;
        newestUs = Math.max(newestUs, originUs + wrapUs);
    }

    /** The camera has set its time to zero. */
    void reset() {
        resets++;
        originUs = newestUs;
        wrapUs = 0;
        wrapMayBeLost = false;
    }

    /** Part of the stream is lost: a step back that follows is a wrap that was in it. */
    void lose() {
        wrapMayBeLost = true;
    }
}
