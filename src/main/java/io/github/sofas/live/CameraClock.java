package io.github.sofas.live;

/**
 * Extends the time of a camera to 64 bits, in µs. The camera sends the low bits with its events, and a wrap each time
 * that these bits overflow. The extended times never decrease. After a camera sets its time to zero, they continue from
 * the newest time. Any other step back is counted and gets the newest time.
 */
final class CameraClock {
    private final long wrapWorthUs;
    /** Extended time at which the camera's time was zero. */
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
     * @param wrapWorthUs time from one overflow of the low bits to the next
     */
    CameraClock(long wrapWorthUs) {
        this.wrapWorthUs = wrapWorthUs;
    }

    long newestUs() {
        return newestUs;
    }

    /** Returns the extended time for the low bits that the camera sent. */
    long extend(int lowBits) {
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

    /** Notes that the low bits have overflowed so many times. */
    void wrap(int times) {
        wraps += times;
        wrapUs += times * wrapWorthUs;
        newestUs = Math.max(newestUs, originUs + wrapUs);
    }

    /** Notes that the camera has set its time to zero. */
    void reset() {
        resets++;
        originUs = newestUs;
        wrapUs = 0;
        wrapMayBeLost = false;
    }

    /** Notes that part of the stream is lost: if the next time steps back, a wrap was in the lost part. */
    void lose() {
        wrapMayBeLost = true;
    }
}
