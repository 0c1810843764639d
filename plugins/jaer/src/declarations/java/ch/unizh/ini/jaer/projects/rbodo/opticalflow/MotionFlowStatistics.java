package ch.unizh.ini.jaer.projects.rbodo.opticalflow;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class MotionFlowStatistics {
    public void updatePacket(int countIn, int countOut, int currentTs) {
        throw new UnsupportedOperationException();
    }
}
