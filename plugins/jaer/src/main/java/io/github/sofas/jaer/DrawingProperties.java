package io.github.sofas.jaer;

import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;

/**
 * The choice of what is drawn, as properties of the filter that jAER shows and keeps in its preferences. Any thread may
 * set them.
 */
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public abstract class DrawingProperties extends GeneratedProperties {
    private static final String DRAWING = "3: SOFAS: what is drawn";

    private volatile FlowDrawing.Colouring eventColours;
    private volatile boolean segmentVelocityShown;
    private volatile boolean segmentLabelsShown;
    private volatile boolean contoursShown;
    private volatile boolean metricShown;
    private volatile boolean legendShown;
    private volatile boolean engineAwaited;

    /** Reads the preferences. */
    protected DrawingProperties(AEChip chip) {
        super(chip);
        eventColours = FlowDrawing.Colouring.of(getString("eventColours", FlowDrawing.Colouring.SEGMENT.name()));
        segmentVelocityShown = getBoolean("segmentVelocityShown", true);
        segmentLabelsShown = getBoolean("segmentLabelsShown", true);
        contoursShown = getBoolean("contoursShown", true);
        metricShown = getBoolean("metricShown", false);
        legendShown = getBoolean("legendShown", true);
        engineAwaited = getBoolean("engineAwaited", false);
        setPropertyTooltip(DRAWING, "eventColours", "<html>what the events since the last picture are coloured by:<br>"
            + "SEGMENT, FLOW (as the colour wheel) or NONE; default SEGMENT");
        setPropertyTooltip(DRAWING, "segmentVelocityShown", "an arrow for each track plane; default on");
        setPropertyTooltip(DRAWING, "segmentLabelsShown",
            "<html>id, velocity and age of each track plane,<br>turn and growth where they are sure; default on");
        setPropertyTooltip(DRAWING, "contoursShown", "contour cells of each track plane; default on");
        setPropertyTooltip(DRAWING, "metricShown",
            "<html>the flow plane's metrics while it searches, brightest at the greatest:<br>directions around,"
            + " speeds outwards (PAPER: angles along x and y); default off");
        setPropertyTooltip(DRAWING, "legendShown", "counts and what the colours mean; default on");
        setPropertyTooltip(DRAWING, "engineAwaited", "<html>whether a picture waits for the flow of its events;<br>else"
            + " flow may be up to " + Engine.MOST_BEHIND + " packets behind, which the legend says; default off");
    }

    /** Shows jAER's colour wheel if colours of events or vectors are directions, which the wheel explains. */
    private void showColourWheel() {
        setDisplayColorWheelLegend(eventColours == FlowDrawing.Colouring.FLOW || isDisplayVectorsEnabled());
    }

    @Override
    public void setDisplayVectorsEnabled(boolean value) {
        super.setDisplayVectorsEnabled(value);
        showColourWheel();
    }

    /** Button: restores the initial choice of what is drawn. */
    @Override
    public void doSetDefaults() {
        super.doSetDefaults();
        setEventColours(FlowDrawing.Colouring.SEGMENT);
        setSegmentVelocityShown(true);
        setSegmentLabelsShown(true);
        setContoursShown(true);
        setMetricShown(false);
        setLegendShown(true);
        setEngineAwaited(false);
    }

    /** What the colours of events show. */
    @Preferred
    public FlowDrawing.Colouring getEventColours() {
        return eventColours;
    }

    /** Sets {@link #getEventColours}. */
    public void setEventColours(FlowDrawing.Colouring value) {
        if (value != null) {
            FlowDrawing.Colouring old = eventColours;
            eventColours = value;
            putString("eventColours", value.name());
            showColourWheel();
            getSupport().firePropertyChange("eventColours", old, value);
        }
    }

    /** Whether an arrow is drawn for each track plane. */
    @Preferred
    public boolean isSegmentVelocityShown() {
        return segmentVelocityShown;
    }

    /** Sets {@link #isSegmentVelocityShown}. */
    public void setSegmentVelocityShown(boolean value) {
        boolean old = segmentVelocityShown;
        segmentVelocityShown = value;
        shown("segmentVelocityShown", old, value);
    }

    /** Whether a label is drawn for each track plane. */
    @Preferred
    public boolean isSegmentLabelsShown() {
        return segmentLabelsShown;
    }

    /** Sets {@link #isSegmentLabelsShown}. */
    public void setSegmentLabelsShown(boolean value) {
        boolean old = segmentLabelsShown;
        segmentLabelsShown = value;
        shown("segmentLabelsShown", old, value);
    }

    /** Whether contour cells are drawn. */
    @Preferred
    public boolean isContoursShown() {
        return contoursShown;
    }

    /** Sets {@link #isContoursShown}. */
    public void setContoursShown(boolean value) {
        boolean old = contoursShown;
        contoursShown = value;
        shown("contoursShown", old, value);
    }

    /** Whether the flow plane's metrics are drawn. */
    @Preferred
    public boolean isMetricShown() {
        return metricShown;
    }

    /** Sets {@link #isMetricShown}. */
    public void setMetricShown(boolean value) {
        boolean old = metricShown;
        metricShown = value;
        shown("metricShown", old, value);
    }

    /** Whether the legend is drawn. */
    @Preferred
    public boolean isLegendShown() {
        return legendShown;
    }

    /** Sets {@link #isLegendShown}. */
    public void setLegendShown(boolean value) {
        boolean old = legendShown;
        legendShown = value;
        shown("legendShown", old, value);
    }

    /** Whether each picture waits for the flow of its events. */
    public boolean isEngineAwaited() {
        return engineAwaited;
    }

    /** Sets {@link #isEngineAwaited}. */
    public void setEngineAwaited(boolean value) {
        boolean old = engineAwaited;
        engineAwaited = value;
        shown("engineAwaited", old, value);
    }

    private void shown(String name, boolean old, boolean value) {
        putBoolean(name, value);
        getSupport().firePropertyChange(name, old, value);
    }
}
