package io.github.sofas.jaer;

import com.jogamp.opengl.GLAutoDrawable;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.beans.PropertyChangeEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.SwingUtilities;
import net.sf.jaer.Description;
import net.sf.jaer.DevelopmentStatus;
import net.sf.jaer.Help;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.graphics.AEViewer;

/**
 * SOFAS as a filter of jAER, in its family of motion-flow filters. jAER's own statistics, ground truth, colour wheel
 * and output events work with this filter as they do with Lucas-Kanade.
 *
 * <p>Packets arrive on the viewer's thread; drawing and buttons run on the thread of the windows. Both threads take the
 * filter's monitor. The engine labels on a thread of its own, which does not take the filter's monitor. Changes of
 * parameters do not take the monitor either.
 */
@Description("SOFAS: optical flow (motion, velocity) of every event, and segmentation and tracking of what moves"
    + " (simultaneous optical flow and segmentation, Stoffregen and Kleeman 2017)")
@Help(SofasHelp.TEXT)
@DevelopmentStatus(DevelopmentStatus.Status.Stable)
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public class SofasFlow extends DrawingProperties {
    private final PacketAdapter adapter = new PacketAdapter();
    private final FlowDrawing drawing = new FlowDrawing();
    private final Counters counters = new Counters();
    private final ReaderWatch watch = new ReaderWatch();
    private final ShownEvents shownEvents = new ShownEvents();
    private final Session session = new Session(log);
    /** Whether a picture was drawn since the last snapshot: the engine then makes one after the next packet. */
    private final AtomicBoolean snapshotWanted = new AtomicBoolean(true);
    private volatile Engine engine;
    private LabelledPacket last = new LabelledPacket();
    private Snapshot snapshot;

    /** Makes a filter for a chip; jAER calls this. */
    public SofasFlow(AEChip chip) {
        super(chip);
        numInputTypes = 2;
        // the family does both to flow of single events; flow of whole structures needs neither
        if (!isPreferenceStored("speedControlEnabled")) {
            setSpeedControlEnabled(false);
        }
        if (!isPreferenceStored("displayVectorsEnabled")) {
            setDisplayVectorsEnabled(false);
        }
        // takes jAER half as much time as the engine takes, and gives one motion for all structures
        if (!isPreferenceStored("displayGlobalMotion")) {
            setDisplayGlobalMotion(false);
        }
        // would ask for a calibration of the inertial sensor at each rewind of a recording
        if (!isPreferenceStored("measureAccuracy")) {
            putBoolean("measureAccuracy", false);
            measureAccuracy = false;
        }
        setPropertyTooltip("reset", "forgets all events and segments");
        setPropertyTooltip("setDefaults", "brings all values of the preset back, and what is shown at first");
        setPropertyTooltip("copyStatistics", "puts what PrintStatistics logs of this filter into the clipboard");
        setPropertyTooltip("writeCsv", "writes the flow of the last packet and the living segments to CSV files");
        setPropertyTooltip("writeSession",
            "<html>writes flow, segments and tracks to CSV files until it is switched off,<br>or the recording"
            + " is rewound; the files are those of ./sofas run");
    }

    @Override
    @SuppressWarnings("rawtypes")
    public synchronized EventPacket filterPacket(EventPacket in) {
        maybeAddListeners(chip);
        watch.follow(chip);
        if (watch.takeMoved()) {
            resetFilter();
        }
        if (in == null || !isReady()) {
            return in;
        }
        // starts jAER's clock of processing
        setupFilter(in);
        boolean together = isTogether();
        handOver(in, null, false);
        LabelledPacket packet = engine.take();
        long start = System.nanoTime();
        adapter.read((EventPacket<?>) in, engine.sofas().sensor(), packet);
        if (!together) {
            packet.keepEvents();
        }
        packet.setReadNs(System.nanoTime() - start);
        engine.submit(packet);
        handOver(in, packet, together);
        getMotionFlowStatistics().updatePacket(countIn, countOut, ts);
        return isDisplayRawInput() ? in : dirPacket;
    }

    /**
     * Whether each packet must wait for its own flow: as the user wishes, for other filters, or for jAER's
     * measurements.
     */
    private boolean isTogether() {
        return isEngineAwaited() || !isDisplayRawInput() || measureAccuracy || isMeasureProcessingTime();
    }

    /**
     * Whether there is an engine for the chip's sensor; makes one if needed. A chip may get its size, or another size,
     * at any time.
     */
    private boolean isReady() {
        int width = chip.getSizeX();
        int height = chip.getSizeY();
        if (width < 1 || height < 1 || width > SensorSize.MAX_WIDTH || height > SensorSize.MAX_HEIGHT) {
            return false;
        }
        SensorSize sensor = engine == null ? null : engine.sofas().sensor();
        if (sensor == null || sensor.width() != width || sensor.height() != height) {
            if (engine != null) {
                endSession();
                engine.await();
            }
            engine = new Engine(new SensorSize(width, height), parameters(), session::add, this::labelled);
            // a parameter may have changed meanwhile
            engine.sofas().setParameters(parameters());
            if (sensor != null) {
                initFilter();
            }
        }
        return true;
    }

    /** Called on the engine's thread after each packet. */
    private void labelled(LabelledPacket packet) {
        if (snapshotWanted.compareAndSet(true, false)) {
            packet.setSnapshot(Snapshot.of(engine.sofas(), isContoursShown(), isMetricShown()));
        }
        session.add(packet);
    }

    /**
     * Passes labelled packets on to jAER.
     *
     * @param now the packet that was read from {@code in}; null if none was read
     */
    private void handOver(EventPacket<?> in, LabelledPacket now, boolean wait) {
        for (LabelledPacket done = engine.next(wait); done != null; done = engine.next(wait)) {
            emit(done, measureAccuracy && done == now ? PacketAdapter.all(in) : null);
            counters.add(done);
            shownEvents.add(done.batch(), done.flow());
            if (done.snapshot() != null) {
                snapshot = done.snapshot();
            }
            engine.giveBack(last);
            last = done;
        }
        if (session.hasFailed()) {
            endSession();
        }
    }

    /** Passes each event with its flow to jAER's family of filters, for statistics, global motion and output events. */
    private void emit(LabelledPacket packet, Iterator<?> all) {
        FlowOutput flow = packet.flow();
        int shift = getSubSampleShift();
        for (int i = 0; i < packet.batch().size(); i++) {
            PolarityEvent event = packet.event(i);
            e = event;
            x = event.x >> shift;
            y = event.y >> shift;
            ts = event.timestamp;
            type = event.polarity == PolarityEvent.Polarity.On ? 1 : 0;
            if (all != null) {
                measureTruth(all, event);
            }
            if (isInvalidAddress(0) || xyFilter()) {
                continue;
            }
            countIn++;
            vx = flow.vxPxPerS[i];
            vy = -flow.vyPxPerS[i];
            v = (float) Math.sqrt(vx * vx + vy * vy);
            if (!accuracyTests()) {
                processGoodEvent();
            }
        }
    }

    /**
     * Passes an event to jAER's estimator of true motion, and before it the inertial samples that preceded the event.
     */
    private void measureTruth(Iterator<?> all, PolarityEvent event) {
        while (all.hasNext()) {
            Object next = all.next();
            if (next == event) {
                break;
            }
            if (next instanceof ApsDvsEvent && ((ApsDvsEvent) next).isImuSample()) {
                imuFlowEstimator.calculateImuFlow(next);
            }
        }
        imuFlowEstimator.calculateImuFlow(event);
    }

    @Override
    protected void parametersChanged() {
        Engine now = engine;
        if (now != null) {
            now.sofas().setParameters(parameters());
        }
    }

    @Override
    public synchronized void resetFilter() {
        super.resetFilter();
        endSession();
        adapter.reset();
        counters.reset();
        shownEvents.clear();
        snapshot = null;
        snapshotWanted.set(true);
        last.clear();
        if (engine != null) {
            engine.reset();
        }
    }

    @Override
    public void propertyChange(PropertyChangeEvent change) {
        super.propertyChange(change);
        // in some releases, the base class of the family leaves this to its filters
        if (AEViewer.EVENT_TIMESTAMPS_RESET.equals(change.getPropertyName()) && isFilterEnabled()) {
            resetFilter();
        }
    }

    /** The events that were passed on last, in the engine's axes; for the thread that filters. */
    public EventBatch lastBatch() {
        return last.batch();
    }

    /** Flow and segment of the events of {@link #lastBatch}. */
    public FlowOutput lastFlow() {
        return last.flow();
    }

    /** Time that the engine took since the last reset, in ns. */
    public long engineNs() {
        return counters.engineNs();
    }

    @Override
    public synchronized void annotate(GLAutoDrawable drawable) {
        if (!isFilterEnabled()) {
            return;
        }
        super.annotate(drawable);
        if (snapshot != null) {
            drawing.draw(drawable.getGL().getGL2(), snapshot, shownEvents, engine.behind(), this);
            shownEvents.setDrawn();
        }
        snapshotWanted.set(true);
    }

    @Override
    @Preferred
    public void doSetDefaults() {
        super.doSetDefaults();
        // the defaults of the family are meant for flow of single events
        setDisplayVectorsEnabled(false);
        setDisplayGlobalMotion(false);
        setSpeedControlEnabled(false);
    }

    /** Button: forgets all events and segments. */
    @Preferred
    public synchronized void doReset() {
        resetFilter();
    }

    @Override
    public synchronized void doPrintStatistics() {
        super.doPrintStatistics();
        log.info(statistics());
    }

    /** Button: puts the statistics into the clipboard. */
    public void doCopyStatistics() {
        String text = statistics();
        if (GraphicsEnvironment.isHeadless()) {
            log.info(text);
        } else {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(text), null);
        }
    }

    private synchronized String statistics() {
        return "SOFAS, since the last reset: " + counters.text()
            + String.format(Locale.ROOT, ", %d segments now", segments().size());
    }

    private List<Segment> segments() {
        return engine == null ? List.of() : engine.sofas().segments();
    }

    /** Button: asks for a name, and writes the flow of the last packet and the living segments. */
    @Preferred
    public void doWriteCsv() {
        Path name = chooseName();
        if (name != null) {
            writeCsv(name);
        }
    }

    synchronized void writeCsv(Path name) {
        session.writeOnce(name, last, segments());
    }

    /** Toggle, on: asks for a name, and writes flow, segments and tracks from now on. */
    @Preferred
    public void doToggleOnWriteSession() {
        Path name = chooseName();
        if (name == null) {
            releaseToggle();
        } else {
            beginSession(name);
        }
    }

    /** Toggle, off: ends what {@link #doToggleOnWriteSession} began. */
    public void doToggleOffWriteSession() {
        endSession();
    }

    synchronized void beginSession(Path name) {
        endSession();
        session.begin(name);
        if (!session.isOn()) {
            releaseToggle();
        }
    }

    synchronized void endSession() {
        if (session.isOn()) {
            // the session includes the packets that are on their way
            finish();
            session.end(segments());
            releaseToggle();
        }
    }

    /** Has jAER's panel show that the session is over, whoever ended it. */
    private void releaseToggle() {
        SwingUtilities.invokeLater(() -> getSupport().firePropertyChange("doToggleOffWriteSession", null, false));
    }

    /** Waits for the packets that are on their way. */
    synchronized void finish() {
        if (engine != null) {
            engine.await();
        }
    }

    private Path chooseName() {
        Path name = ResultChooser.choose(null, getString("csvFile",
            new File(System.getProperty("user.home"), "sofas").getPath()));
        if (name != null) {
            putString("csvFile", name.toString());
        }
        return name;
    }
}
