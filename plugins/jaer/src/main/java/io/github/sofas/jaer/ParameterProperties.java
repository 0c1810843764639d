package io.github.sofas.jaer;

import ch.unizh.ini.jaer.projects.rbodo.opticalflow.AbstractMotionFlowIMU;
import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.SofasParameters.Preset;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;

/**
 * The parameters of {@link SofasParameters} as properties of the filter. jAER finds properties by their getters and
 * setters, shows them, and keeps them in its preferences. This class holds what all properties have in common; their
 * getters and setters are generated. Any thread may call the setters. A value outside its bounds is moved into them,
 * with a line in the log.
 */
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public abstract class ParameterProperties extends AbstractMotionFlowIMU {
    /** Group of the preset. jAER sorts groups by name: with these names, those of SOFAS come before its own. */
    private static final String METHOD = "0: SOFAS";
    /** Groups of the parameters, named for the user by what they decide. */
    private static final List<String> GROUPS = List.of("1: SOFAS: what is found", "2: SOFAS: how long it is followed",
        "4: SOFAS: paper preset only");
    /**
     * Hidden properties of the family: meant for flow of single events, which is smoothed, spread and judged one by
     * one.
     */
    private static final List<String> MEANINGLESS = List.of("refractoryPeriodUs", "timestampGapThresholdUs",
        "warnNonmonotonicTimestamps", "subSampleShift", "speedControlEnabled", "speedControl_ExcessSpeedRejectFactor",
        "speedControl_SpeedMixingFactor", "discardOutliersEnabled", "outlierMotionFilteringEnabled", "epsilon",
        "randomScatterOnFlowVectorOrigins", "displayZeroLengthVectorsEnabled", "ppsScaleDisplayRelativeOFLength",
        "displayMotionField", "displayMotionFieldColorBlobs", "displayMotionFieldUsingColor",
        "motionFieldDiffusionEnabled", "motionFieldMixingFactor", "motionFieldSubsamplingShift",
        "motionFieldTimeConstantMs", "maxAgeUs", "minSpeedPpsToDrawMotionField", "consistentWithNeighbors",
        "consistentWithCurrentAngle", "decayTowardsZeroPeridiclly", "motionField", "imuFlowEstimator");

    private final ParameterValues values;

    /** Reads the preferences. */
    protected ParameterProperties(AEChip chip) {
        super(chip);
        values = new ParameterValues(SofasParameters.of(storedPreset()));
        setPropertyTooltip(METHOD, "preset", "<html>which method the others belong to, and their values when it is"
            + " chosen:<br>DEFAULT is most accurate and fast, PAPER is the method as published; default DEFAULT");
        // twice, because a parameter may bound another that comes before it
        restore();
        restore().forEach(log::warning);
        List<String> groups = ParameterHandle.all().stream().map(ParameterHandle::group).distinct().toList();
        for (ParameterHandle handle : ParameterHandle.all()) {
            setPropertyTooltip(GROUPS.get(groups.indexOf(handle.group())), handle.name(),
                ParameterValues.tooltip(handle));
        }
        MEANINGLESS.forEach(this::hideProperty);
    }

    private Preset storedPreset() {
        String name = getString("preset", Preset.DEFAULT.name());
        for (Preset preset : Preset.values()) {
            if (preset.name().equals(name)) {
                return preset;
            }
        }
        log.warning("preset must be DEFAULT or PAPER but was " + name + "; set to DEFAULT");
        return Preset.DEFAULT;
    }

    /** Sets the parameters from the preferences; returns a message for each value that had to be changed. */
    private List<String> restore() {
        List<String> wrong = new ArrayList<>();
        SofasParameters preset = SofasParameters.of(values.parameters().preset());
        for (ParameterHandle handle : ParameterHandle.all()) {
            String name = handle.name();
            Object value = handle.get(preset);
            if (handle.isSwitch()) {
                values.set(name, getBoolean(name, (Boolean) value));
            } else if (handle.isWhole()) {
                wrong.add(values.set(name, (double) getInt(name, ((Number) value).intValue())));
            } else {
                wrong.add(values.set(name, exactly(getFloat(name, ((Number) value).floatValue()))));
            }
        }
        wrong.removeIf(String::isEmpty);
        return wrong;
    }

    /** The parameters that the controls show. */
    protected final SofasParameters parameters() {
        return values.parameters();
    }

    /** Is called after each change, by the thread that made the change. */
    protected abstract void parametersChanged();

    final double number(String name) {
        return values.number(name);
    }

    final boolean isOn(String name) {
        return values.isOn(name);
    }

    /** The decimal number that a float represents: 0.15f is 0.15, not 0.15000000596. */
    private static double exactly(float value) {
        return Double.parseDouble(Float.toString(value));
    }

    final void set(String name, int value) {
        int old = (int) values.number(name);
        warn(values.set(name, (double) value));
        int taken = (int) values.number(name);
        putInt(name, taken);
        changed(name, old, taken, value);
    }

    final void set(String name, float value) {
        float old = (float) values.number(name);
        warn(values.set(name, exactly(value)));
        float taken = (float) values.number(name);
        putFloat(name, taken);
        changed(name, old, taken, value);
    }

    final void set(String name, boolean value) {
        boolean old = values.isOn(name);
        values.set(name, value);
        putBoolean(name, value);
        changed(name, old, value, value);
    }

    private static void warn(String message) {
        if (!message.isEmpty()) {
            log.warning(message);
        }
    }

    /** Notifies the control, after the field is set; also if the control shows another value than the one taken. */
    private void changed(String name, Object old, Object taken, Object asked) {
        parametersChanged();
        getSupport().firePropertyChange(name, taken.equals(asked) ? old : asked, taken);
    }

    /** The preset: the method that the other parameters belong to. */
    @Preferred
    public Preset getPreset() {
        return values.parameters().preset();
    }

    /** Sets all parameters to the values of a preset. */
    public void setPreset(Preset preset) {
        if (preset != null && preset != getPreset()) {
            takeOver(preset);
        }
    }

    /** Button: brings all values of the preset back. */
    @Override
    public void doSetDefaults() {
        super.doSetDefaults();
        takeOver(getPreset());
    }

    private void takeOver(Preset preset) {
        SofasParameters before = values.parameters();
        values.setPreset(preset);
        SofasParameters after = values.parameters();
        putString("preset", preset.name());
        parametersChanged();
        getSupport().firePropertyChange("preset", before.preset(), preset);
        for (ParameterHandle handle : ParameterHandle.all()) {
            Object was = shown(handle, before);
            Object is = shown(handle, after);
            if (is instanceof Boolean) {
                putBoolean(handle.name(), (Boolean) is);
            } else if (is instanceof Float) {
                putFloat(handle.name(), (Float) is);
            } else {
                putInt(handle.name(), (Integer) is);
            }
            getSupport().firePropertyChange(handle.name(), was, is);
        }
    }

    /** A value in the type of its control. */
    private static Object shown(ParameterHandle handle, SofasParameters parameters) {
        Object value = handle.get(parameters);
        if (value instanceof Double) {
            return ((Double) value).floatValue();
        }
        return value instanceof Long ? (Object) ((Long) value).intValue() : value;
    }
}
