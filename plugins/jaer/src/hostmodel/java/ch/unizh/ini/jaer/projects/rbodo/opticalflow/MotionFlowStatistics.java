package ch.unizh.ini.jaer.projects.rbodo.opticalflow;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class MotionFlowStatistics {
    public int packets;

    public void updatePacket(int countIn, int countOut, int currentTs) {
        packets++;
    }
}
