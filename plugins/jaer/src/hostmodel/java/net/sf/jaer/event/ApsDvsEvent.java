package net.sf.jaer.event;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class ApsDvsEvent extends PolarityEvent {
    public boolean imuSample;
    public boolean apsData;

    public boolean isImuSample() {
        return imuSample;
    }

    public boolean isDVSEvent() {
        return !imuSample && !apsData;
    }
}
