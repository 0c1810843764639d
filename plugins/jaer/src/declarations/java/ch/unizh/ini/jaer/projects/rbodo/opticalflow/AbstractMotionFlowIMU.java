package ch.unizh.ini.jaer.projects.rbodo.opticalflow;

import com.jogamp.opengl.GLAutoDrawable;
import java.beans.PropertyChangeEvent;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.eventprocessing.EventFilter2DMouseAdaptor;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
@SuppressWarnings("unchecked")
public abstract class AbstractMotionFlowIMU extends EventFilter2DMouseAdaptor {
    public static float vx;
    public static float vy;
    public static float v;

    public int numInputTypes;
    public int x;
    public int y;
    public int ts;
    public int type;
    public int countIn;
    public int countOut;
    public boolean measureAccuracy;
    public ImuFlowEstimator imuFlowEstimator;

    protected PolarityEvent e;
    @SuppressWarnings("rawtypes")
    protected EventPacket dirPacket;

    public class ImuFlowEstimator {
        public boolean calculateImuFlow(Object o) {
            throw new UnsupportedOperationException();
        }
    }

    public AbstractMotionFlowIMU(AEChip chip) {
        super(chip);
        throw new UnsupportedOperationException();
    }

    @Override
    @SuppressWarnings("rawtypes")
    public abstract EventPacket filterPacket(EventPacket in);

    @Override
    public synchronized void resetFilter() {
        throw new UnsupportedOperationException();
    }

    @Override
    public void initFilter() {
        throw new UnsupportedOperationException();
    }

    @Override
    public void propertyChange(PropertyChangeEvent evt) {
        throw new UnsupportedOperationException();
    }

    @Override
    public synchronized void annotate(GLAutoDrawable drawable) {
        throw new UnsupportedOperationException();
    }

    @SuppressWarnings("rawtypes")
    public synchronized void setupFilter(EventPacket in) {
        throw new UnsupportedOperationException();
    }

    protected synchronized boolean isInvalidAddress(int d) {
        throw new UnsupportedOperationException();
    }

    protected boolean xyFilter() {
        throw new UnsupportedOperationException();
    }

    public synchronized boolean accuracyTests() {
        throw new UnsupportedOperationException();
    }

    public synchronized void processGoodEvent() {
        throw new UnsupportedOperationException();
    }

    public synchronized void doPrintStatistics() {
        throw new UnsupportedOperationException();
    }

    public void doSetDefaults() {
        throw new UnsupportedOperationException();
    }

    public MotionFlowStatistics getMotionFlowStatistics() {
        throw new UnsupportedOperationException();
    }

    public void setDisplayRawInput(boolean displayRawInput) {
        throw new UnsupportedOperationException();
    }

    public boolean isDisplayRawInput() {
        throw new UnsupportedOperationException();
    }

    public void setSpeedControlEnabled(boolean speedControlEnabled) {
        throw new UnsupportedOperationException();
    }

    public void setDisplayVectorsEnabled(boolean displayVectorsEnabled) {
        throw new UnsupportedOperationException();
    }

    public boolean isDisplayVectorsEnabled() {
        throw new UnsupportedOperationException();
    }

    public void setDisplayColorWheelLegend(boolean displayColorWheelLegend) {
        throw new UnsupportedOperationException();
    }

    public int getFontSize() {
        throw new UnsupportedOperationException();
    }

    public void setDisplayGlobalMotion(boolean displayGlobalMotion) {
        throw new UnsupportedOperationException();
    }

    public synchronized boolean isMeasureProcessingTime() {
        throw new UnsupportedOperationException();
    }

    public int getSubSampleShift() {
        throw new UnsupportedOperationException();
    }
}
