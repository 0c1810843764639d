package io.github.sofas.jaer;

import com.jogamp.opengl.GLAutoDrawable;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.beans.PropertyChangeEvent;
import java.io.File;
import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import javax.swing.JFileChooser;
import net.sf.jaer.Description;
import net.sf.jaer.DevelopmentStatus;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;
import net.sf.jaer.graphics.AEViewer;

/**
 * SOFAS in jAER, of the family of motion-flow filters: jAER's own statistics, ground truth, colour wheel and output
 * events serve it as they serve Lucas-Kanade.
 *
 * <p>Packets come on the viewer's thread, drawing and buttons on that of the windows; both take the filter's monitor,
 * and neither waits for the other while it has it. Parameters do not take it.
 */
@Description("SOFAS: simultaneous optical flow and segmentation (Stoffregen and Kleeman 2017)")
@DevelopmentStatus(DevelopmentStatus.Status.Stable)
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public class SofasFlow extends DrawingProperties {
    private final PacketAdapter adapter = new PacketAdapter();
    private final FlowDrawing drawing = new FlowDrawing();
    private final Counters counters = new Counters();
    private final ReaderWatch watch = new ReaderWatch();
    private final ShownEvents shownEvents = new ShownEvents();
    private volatile Sofas sofas;
    private Snapshot snapshot;

    /** Is called by jAER. */
    public SofasFlow(AEChip chip) {
        super(chip);
        numInputTypes = 2;
        // what the family does to flow of single events: flow of whole structures needs neither
        if (!isPreferenceStored("speedControlEnabled")) {
            setSpeedControlEnabled(false);
        }
        if (!isPreferenceStored("displayVectorsEnabled")) {
            setDisplayVectorsEnabled(false);
        }
        // costs jAER half as much again as the engine, and is one motion for all structures
        if (!isPreferenceStored("displayGlobalMotion")) {
            setDisplayGlobalMotion(false);
        }
        // would ask for a calibration of the inertial sensor at each rewind
        if (!isPreferenceStored("measureAccuracy")) {
            putBoolean("measureAccuracy", false);
            measureAccuracy = false;
        }
        // times and gaps are the engine's business, which takes them as they are
        hideProperty("refractoryPeriodUs");
        hideProperty("timestampGapThresholdUs");
        hideProperty("warnNonmonotonicTimestamps");
        setPropertyTooltip("reset", "forgets all events and segments");
        setPropertyTooltip("setDefaults", "brings all values of the preset back, and what is shown at first");
        setPropertyTooltip("copyStatistics", "puts what PrintStatistics logs of this filter into the clipboard");
        setPropertyTooltip("writeCsv", "writes the flow of the last packet and the living segments to two CSV files");
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
        long start = System.nanoTime();
        adapter.read((EventPacket<?>) in, sofas.sensor());
        long read = System.nanoTime();
        sofas.process(adapter.batch(), adapter.output());
        snapshot = Snapshot.of(sofas, isContoursShown(), isMetricShown());
        shownEvents.add(adapter.batch(), adapter.output());
        long labelled = System.nanoTime();
        emit((EventPacket<?>) in);
        getMotionFlowStatistics().updatePacket(countIn, countOut, ts);
        counters.add(adapter.batch(), adapter.output(), read - start, labelled - read);
        return isDisplayRawInput() ? in : dirPacket;
    }

    /** Whether there is an engine for the chip's sensor; a chip may get its size, and another, at any time. */
    private boolean isReady() {
        int width = chip.getSizeX();
        int height = chip.getSizeY();
        if (width < 1 || height < 1 || width > SensorSize.MAX_WIDTH || height > SensorSize.MAX_HEIGHT) {
            return false;
        }
        if (sofas == null || sofas.sensor().width() != width || sofas.sensor().height() != height) {
            boolean first = sofas == null;
            sofas = new Sofas(new SensorSize(width, height), parameters());
            // a parameter that changed meanwhile
            sofas.setParameters(parameters());
            adapter.reset();
            if (!first) {
                initFilter();
            }
        }
        return true;
    }

    /** Hands each event with its flow to jAER's family: statistics, global motion, output events. */
    private void emit(EventPacket<?> in) {
        FlowOutput flow = adapter.output();
        int shift = getSubSampleShift();
        Iterator<?> all = measureAccuracy ? PacketAdapter.all(in) : null;
        for (int i = 0; i < adapter.batch().size(); i++) {
            PolarityEvent event = adapter.event(i);
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

    /** Shows jAER's estimator of true motion what came before an event, and the event. */
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
        Sofas engine = sofas;
        if (engine != null) {
            engine.setParameters(parameters());
        }
    }

    @Override
    public synchronized void resetFilter() {
        super.resetFilter();
        adapter.reset();
        counters.reset();
        shownEvents.clear();
        snapshot = null;
        if (sofas != null) {
            sofas.reset();
        }
    }

    @Override
    public void propertyChange(PropertyChangeEvent change) {
        super.propertyChange(change);
        // the family's base leaves this to its filters in some releases
        if (AEViewer.EVENT_TIMESTAMPS_RESET.equals(change.getPropertyName()) && isFilterEnabled()) {
            resetFilter();
        }
    }

    /** The events of the last packet, in the engine's axes; from the thread that filters. */
    public EventBatch lastBatch() {
        return adapter.batch();
    }

    /** Flow and segment of the events of {@link #lastBatch}. */
    public FlowOutput lastFlow() {
        return adapter.output();
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
            drawing.draw(drawable.getGL().getGL2(), snapshot, shownEvents, 0, this);
            shownEvents.setDrawn();
        }
    }

    @Override
    public void doSetDefaults() {
        super.doSetDefaults();
        // the family's defaults are for flow of single events
        setDisplayVectorsEnabled(false);
        setDisplayGlobalMotion(false);
        setSpeedControlEnabled(false);
    }

    /** Button: forgets all. */
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
        return sofas == null ? List.of() : sofas.segments();
    }

    /** Button: asks for a file, and writes the last packet's flow and the living segments beside it. */
    public void doWriteCsv() {
        // what is shown now, not what is there when a file has been chosen
        CsvFiles files;
        synchronized (this) {
            files = CsvFiles.of(adapter.batch(), adapter.output(), segments());
        }
        JFileChooser chooser = new JFileChooser(getString("csvFile", System.getProperty("user.home")));
        chooser.setDialogTitle("Write NAME.flow.csv and NAME.segments.csv");
        chooser.setSelectedFile(new File(getString("csvFile", "sofas")));
        if (chooser.showSaveDialog(null) == JFileChooser.APPROVE_OPTION) {
            File name = chooser.getSelectedFile();
            putString("csvFile", name.getPath());
            try {
                log.info(files.write(name.toPath()));
            } catch (IOException failure) {
                log.warning("SOFAS could not write " + name + ": " + failure);
            }
        }
    }
}
