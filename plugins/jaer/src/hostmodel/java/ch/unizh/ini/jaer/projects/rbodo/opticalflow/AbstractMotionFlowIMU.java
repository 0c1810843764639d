package ch.unizh.ini.jaer.projects.rbodo.opticalflow;

import com.jogamp.opengl.GLAutoDrawable;
import java.beans.PropertyChangeEvent;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.eventprocessing.EventFilter2DMouseAdaptor;

/** As much of the class of that name in jAER as the tests of the filter need. */
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
    protected EventPacket dirPacket = new EventPacket();
    /** What was handed over, a line an event. */
    public final List<String> good = new ArrayList<>();
    /** IMU samples and events that true motion was asked of. */
    public final List<Object> truthAsked = new ArrayList<>();
    public boolean displayRawInput = true;
    public boolean speedControlEnabled = true;
    public boolean displayVectorsEnabled = true;
    public boolean displayGlobalMotion = true;
    public boolean displayColorWheelLegend = true;
    public int fontSize = 6;
    public int resets;
    public boolean measureProcessingTime;
    public Runnable clockStarted = () -> { };
    private final MotionFlowStatistics statistics = new MotionFlowStatistics();

    public class ImuFlowEstimator {
        public boolean calculateImuFlow(Object o) {
            truthAsked.add(o);
            return false;
        }
    }

    public AbstractMotionFlowIMU(AEChip chip) {
        super(chip);
        measureAccuracy = getBoolean("measureAccuracy", true);
        imuFlowEstimator = new ImuFlowEstimator();
        setPropertyTooltip("displayVectorsEnabled", "vectors");
    }

    @Override
    @SuppressWarnings("rawtypes")
    public abstract EventPacket filterPacket(EventPacket in);

    @Override
    public synchronized void resetFilter() {
        resets++;
        doPrintStatistics();
    }

    @Override
    public void initFilter() {
        setDisplayGlobalMotion(getBoolean("displayGlobalMotion", true));
        resetFilter();
    }

    @Override
    public void propertyChange(PropertyChangeEvent evt) {
        super.propertyChange(evt);
    }

    @Override
    public synchronized void annotate(GLAutoDrawable drawable) {
        
    }

    @SuppressWarnings("rawtypes")
    public synchronized void setupFilter(EventPacket in) {
        // jAER's clock of processing starts here
        clockStarted.run();
        countIn = 0;
        countOut = 0;
    }

    protected synchronized boolean isInvalidAddress(int d) {
        return x < d || y < d || x >= chip.getSizeX() - d || y >= chip.getSizeY() - d;
    }

    protected boolean xyFilter() {
        return false;
    }

    public synchronized boolean accuracyTests() {
        return false;
    }

    public synchronized void processGoodEvent() {
        good.add(ts + " " + x + " " + y + " " + type + " " + vx + " " + vy);
        countOut++;
    }

    public synchronized void doPrintStatistics() {
        
    }

    public void doSetDefaults() {
        setDisplayVectorsEnabled(true);
        setDisplayGlobalMotion(true);
    }

    public MotionFlowStatistics getMotionFlowStatistics() {
        return statistics;
    }

    public boolean isDisplayRawInput() {
        return displayRawInput;
    }

    public void setSpeedControlEnabled(boolean speedControlEnabled) {
        this.speedControlEnabled = speedControlEnabled;
        putBoolean("speedControlEnabled", speedControlEnabled);
    }

    public void setDisplayVectorsEnabled(boolean displayVectorsEnabled) {
        this.displayVectorsEnabled = displayVectorsEnabled;
        putBoolean("displayVectorsEnabled", displayVectorsEnabled);
    }

    public boolean isDisplayVectorsEnabled() {
        return displayVectorsEnabled;
    }

    public void setDisplayColorWheelLegend(boolean value) {
        displayColorWheelLegend = value;
    }

    public int getFontSize() {
        return fontSize;
    }

    public void setDisplayGlobalMotion(boolean displayGlobalMotion) {
        this.displayGlobalMotion = displayGlobalMotion;
        putBoolean("displayGlobalMotion", displayGlobalMotion);
    }

    public synchronized boolean isMeasureProcessingTime() {
        return measureProcessingTime;
    }

    public int getSubSampleShift() {
        return 0;
    }
}
