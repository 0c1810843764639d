package io.github.sofas.jaer;

import ch.unizh.ini.jaer.projects.rbodo.opticalflow.AbstractMotionFlowIMU;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.SofasParameters.Preset;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;

/**
 * Every component of {@link SofasParameters} as a property that jAER finds by its getter and setter, shows, and keeps
 * in its preferences. Setters may be called by any thread; a value outside its bounds is moved into them, with a line
 * in the log.
 */
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public abstract class ParameterProperties extends AbstractMotionFlowIMU {
    private static final String METHOD = "0: SOFAS";
    private static final String SEARCH = "1: SOFAS flow plane";
    private static final String TRACK = "2: SOFAS track planes";
    private static final List<String> OF_THE_SEARCH = List.of("flowProjections", "velocityScalePxPerS", "rangeDeg",
        "refinement", "cycles", "constantEvents", "slowestPxPerS", "fastestPxPerS", "flowTravelPx", "lifespanUs",
        "thresholdSd", "minEvents", "evidence", "slowestWithin");

    private final ParameterValues values;

    /** Reads the preferences. */
    protected ParameterProperties(AEChip chip) {
        super(chip);
        values = new ParameterValues(ParameterValues.of(storedPreset()));
        setPropertyTooltip(METHOD, "preset", "<html>which method the others belong to, and their values when it is"
            + " chosen:<br>DEFAULT is most accurate and fast, PAPER is the method as published; default DEFAULT");
        // twice, because one may bound another that comes before it
        restore();
        restore().forEach(log::warning);
        for (RecordComponent component : ParameterValues.components()) {
            setPropertyTooltip(OF_THE_SEARCH.contains(component.getName()) ? SEARCH : TRACK, component.getName(),
                ParameterValues.tooltip(component));
        }
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

    /** Sets what the preferences say; returns what was wrong with it. */
    private List<String> restore() {
        List<String> wrong = new ArrayList<>();
        SofasParameters preset = ParameterValues.of(values.parameters().preset());
        for (RecordComponent component : ParameterValues.components()) {
            String name = component.getName();
            Object value = ParameterValues.value(component, preset);
            if (component.getType() == boolean.class) {
                values.set(name, getBoolean(name, (Boolean) value));
            } else if (component.getType() == double.class) {
                wrong.add(values.set(name, exactly(getFloat(name, ((Number) value).floatValue()))));
            } else {
                wrong.add(values.set(name, (double) getInt(name, ((Number) value).intValue())));
            }
        }
        wrong.removeIf(String::isEmpty);
        return wrong;
    }

    /** The parameters that the controls show. */
    protected final SofasParameters parameters() {
        return values.parameters();
    }

    /** Is called after each change, by the thread that made it. */
    protected abstract void parametersChanged();

    /** The decimal number that a float stands for: 0.15f is 0.15, not 0.15000000596. */
    private static double exactly(float value) {
        return Double.parseDouble(Float.toString(value));
    }

    private void set(String name, int value) {
        int old = (int) values.number(name);
        warn(values.set(name, (double) value));
        int taken = (int) values.number(name);
        putInt(name, taken);
        changed(name, old, taken, value);
    }

    private void set(String name, float value) {
        float old = (float) values.number(name);
        warn(values.set(name, exactly(value)));
        float taken = (float) values.number(name);
        putFloat(name, taken);
        changed(name, old, taken, value);
    }

    private void set(String name, boolean value) {
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

    /** The control is told after the field is set, and also where it shows another value than was taken. */
    private void changed(String name, Object old, Object taken, Object asked) {
        parametersChanged();
        getSupport().firePropertyChange(name, taken.equals(asked) ? old : asked, taken);
    }

    /** Which method the other parameters belong to. */
    @Preferred
    public Preset getPreset() {
        return values.parameters().preset();
    }

    /** Takes over all values of a preset. */
    public void setPreset(Preset preset) {
        if (preset == null || preset == getPreset()) {
            return;
        }
        SofasParameters before = values.parameters();
        values.setPreset(preset);
        SofasParameters after = values.parameters();
        putString("preset", preset.name());
        parametersChanged();
        getSupport().firePropertyChange("preset", before.preset(), preset);
        for (RecordComponent component : ParameterValues.components()) {
            Object was = shown(component, before);
            Object is = shown(component, after);
            if (is instanceof Boolean) {
                putBoolean(component.getName(), (Boolean) is);
            } else if (is instanceof Float) {
                putFloat(component.getName(), (Float) is);
            } else {
                putInt(component.getName(), (Integer) is);
            }
            getSupport().firePropertyChange(component.getName(), was, is);
        }
    }

    /** A value in the type that a control has. */
    private static Object shown(RecordComponent component, SofasParameters parameters) {
        Object value = ParameterValues.value(component, parameters);
        if (value instanceof Double) {
            return ((Double) value).floatValue();
        }
        return value instanceof Long ? (Object) ((Long) value).intValue() : value;
    }

    /** The parameter {@link SofasParameters#flowProjections}. */
    public int getFlowProjections() {
        return (int) values.number("flowProjections");
    }

    /** Sets {@link #getFlowProjections}. */
    public void setFlowProjections(int value) {
        set("flowProjections", value);
    }

    /** Left end of its slider. */
    public int getMinFlowProjections() {
        return 3;
    }

    /** Right end of its slider. */
    public int getMaxFlowProjections() {
        return 31;
    }

    /** The parameter {@link SofasParameters#velocityScalePxPerS}. */
    public float getVelocityScalePxPerS() {
        return (float) values.number("velocityScalePxPerS");
    }

    /** Sets {@link #getVelocityScalePxPerS}. */
    public void setVelocityScalePxPerS(float value) {
        set("velocityScalePxPerS", value);
    }

    /** The parameter {@link SofasParameters#rangeDeg}. */
    public float getRangeDeg() {
        return (float) values.number("rangeDeg");
    }

    /** Sets {@link #getRangeDeg}. */
    public void setRangeDeg(float value) {
        set("rangeDeg", value);
    }

    /** Left end of its slider. */
    public float getMinRangeDeg() {
        return 1f;
    }

    /** Right end of its slider. */
    public float getMaxRangeDeg() {
        return 180f;
    }

    /** The parameter {@link SofasParameters#refinement}. */
    public float getRefinement() {
        return (float) values.number("refinement");
    }

    /** Sets {@link #getRefinement}. */
    public void setRefinement(float value) {
        set("refinement", value);
    }

    /** The parameter {@link SofasParameters#cycles}. */
    public int getCycles() {
        return (int) values.number("cycles");
    }

    /** Sets {@link #getCycles}. */
    public void setCycles(int value) {
        set("cycles", value);
    }

    /** Left end of its slider. */
    public int getMinCycles() {
        return 1;
    }

    /** Right end of its slider. */
    public int getMaxCycles() {
        return 6;
    }

    /** The parameter {@link SofasParameters#constantEvents}. */
    public int getConstantEvents() {
        return (int) values.number("constantEvents");
    }

    /** Sets {@link #getConstantEvents}. */
    public void setConstantEvents(int value) {
        set("constantEvents", value);
    }

    /** The parameter {@link SofasParameters#slowestPxPerS}. */
    @Preferred
    public float getSlowestPxPerS() {
        return (float) values.number("slowestPxPerS");
    }

    /** Sets {@link #getSlowestPxPerS}. */
    public void setSlowestPxPerS(float value) {
        set("slowestPxPerS", value);
    }

    /** The parameter {@link SofasParameters#fastestPxPerS}. */
    @Preferred
    public float getFastestPxPerS() {
        return (float) values.number("fastestPxPerS");
    }

    /** Sets {@link #getFastestPxPerS}. */
    public void setFastestPxPerS(float value) {
        set("fastestPxPerS", value);
    }

    /** The parameter {@link SofasParameters#flowTravelPx}. */
    public float getFlowTravelPx() {
        return (float) values.number("flowTravelPx");
    }

    /** Sets {@link #getFlowTravelPx}. */
    public void setFlowTravelPx(float value) {
        set("flowTravelPx", value);
    }

    /** Left end of its slider. */
    public float getMinFlowTravelPx() {
        return 2f;
    }

    /** Right end of its slider. */
    public float getMaxFlowTravelPx() {
        return 32f;
    }

    /** The parameter {@link SofasParameters#lifespanUs}. */
    public int getLifespanUs() {
        return (int) values.number("lifespanUs");
    }

    /** Sets {@link #getLifespanUs}. */
    public void setLifespanUs(int value) {
        set("lifespanUs", value);
    }

    /** The parameter {@link SofasParameters#thresholdSd}. */
    public float getThresholdSd() {
        return (float) values.number("thresholdSd");
    }

    /** Sets {@link #getThresholdSd}. */
    public void setThresholdSd(float value) {
        set("thresholdSd", value);
    }

    /** Left end of its slider. */
    public float getMinThresholdSd() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxThresholdSd() {
        return 10f;
    }

    /** The parameter {@link SofasParameters#minEvents}. */
    public int getMinEvents() {
        return (int) values.number("minEvents");
    }

    /** Sets {@link #getMinEvents}. */
    public void setMinEvents(int value) {
        set("minEvents", value);
    }

    /** The parameter {@link SofasParameters#evidence}. */
    public float getEvidence() {
        return (float) values.number("evidence");
    }

    /** Sets {@link #getEvidence}. */
    public void setEvidence(float value) {
        set("evidence", value);
    }

    /** The parameter {@link SofasParameters#slowestWithin}. */
    public float getSlowestWithin() {
        return (float) values.number("slowestWithin");
    }

    /** Sets {@link #getSlowestWithin}. */
    public void setSlowestWithin(float value) {
        set("slowestWithin", value);
    }

    /** The parameter {@link SofasParameters#lifetimePx}. */
    @Preferred
    public float getLifetimePx() {
        return (float) values.number("lifetimePx");
    }

    /** Sets {@link #getLifetimePx}. */
    public void setLifetimePx(float value) {
        set("lifetimePx", value);
    }

    /** The parameter {@link SofasParameters#maxLifetimePx}. */
    @Preferred
    public float getMaxLifetimePx() {
        return (float) values.number("maxLifetimePx");
    }

    /** Sets {@link #getMaxLifetimePx}. */
    public void setMaxLifetimePx(float value) {
        set("maxLifetimePx", value);
    }

    /** The parameter {@link SofasParameters#maxLifetimeUs}. */
    public int getMaxLifetimeUs() {
        return (int) values.number("maxLifetimeUs");
    }

    /** Sets {@link #getMaxLifetimeUs}. */
    public void setMaxLifetimeUs(int value) {
        set("maxLifetimeUs", value);
    }

    /** The parameter {@link SofasParameters#steadyPx}. */
    public float getSteadyPx() {
        return (float) values.number("steadyPx");
    }

    /** Sets {@link #getSteadyPx}. */
    public void setSteadyPx(float value) {
        set("steadyPx", value);
    }

    /** The parameter {@link SofasParameters#hitShare}. */
    public float getHitShare() {
        return (float) values.number("hitShare");
    }

    /** Sets {@link #getHitShare}. */
    public void setHitShare(float value) {
        set("hitShare", value);
    }

    /** The parameter {@link SofasParameters#minPerturbationDeg}. */
    public float getMinPerturbationDeg() {
        return (float) values.number("minPerturbationDeg");
    }

    /** Sets {@link #getMinPerturbationDeg}. */
    public void setMinPerturbationDeg(float value) {
        set("minPerturbationDeg", value);
    }

    /** The parameter {@link SofasParameters#maxPerturbationDeg}. */
    public float getMaxPerturbationDeg() {
        return (float) values.number("maxPerturbationDeg");
    }

    /** Sets {@link #getMaxPerturbationDeg}. */
    public void setMaxPerturbationDeg(float value) {
        set("maxPerturbationDeg", value);
    }

    /** The parameter {@link SofasParameters#contourThreshold}. */
    public int getContourThreshold() {
        return (int) values.number("contourThreshold");
    }

    /** Sets {@link #getContourThreshold}. */
    public void setContourThreshold(int value) {
        set("contourThreshold", value);
    }

    /** The parameter {@link SofasParameters#contourShare}. */
    @Preferred
    public float getContourShare() {
        return (float) values.number("contourShare");
    }

    /** Sets {@link #getContourShare}. */
    public void setContourShare(float value) {
        set("contourShare", value);
    }

    /** Left end of its slider. */
    public float getMinContourShare() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxContourShare() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#memoryPx}. */
    public float getMemoryPx() {
        return (float) values.number("memoryPx");
    }

    /** Sets {@link #getMemoryPx}. */
    public void setMemoryPx(float value) {
        set("memoryPx", value);
    }

    /** The parameter {@link SofasParameters#maxMemoryUs}. */
    public int getMaxMemoryUs() {
        return (int) values.number("maxMemoryUs");
    }

    /** Sets {@link #getMaxMemoryUs}. */
    public void setMaxMemoryUs(int value) {
        set("maxMemoryUs", value);
    }

    /** The parameter {@link SofasParameters#voteCellPx}. */
    public float getVoteCellPx() {
        return (float) values.number("voteCellPx");
    }

    /** Sets {@link #getVoteCellPx}. */
    public void setVoteCellPx(float value) {
        set("voteCellPx", value);
    }

    /** The parameter {@link SofasParameters#sampleEvents}. */
    public int getSampleEvents() {
        return (int) values.number("sampleEvents");
    }

    /** Sets {@link #getSampleEvents}. */
    public void setSampleEvents(int value) {
        set("sampleEvents", value);
    }

    /** The parameter {@link SofasParameters#sampleDensity}. */
    public float getSampleDensity() {
        return (float) values.number("sampleDensity");
    }

    /** Sets {@link #getSampleDensity}. */
    public void setSampleDensity(float value) {
        set("sampleDensity", value);
    }

    /** The parameter {@link SofasParameters#neighbourLoss}. */
    public float getNeighbourLoss() {
        return (float) values.number("neighbourLoss");
    }

    /** Sets {@link #getNeighbourLoss}. */
    public void setNeighbourLoss(float value) {
        set("neighbourLoss", value);
    }

    /** The parameter {@link SofasParameters#minStepPx}. */
    public float getMinStepPx() {
        return (float) values.number("minStepPx");
    }

    /** Sets {@link #getMinStepPx}. */
    public void setMinStepPx(float value) {
        set("minStepPx", value);
    }

    /** The parameter {@link SofasParameters#maxStepPx}. */
    public float getMaxStepPx() {
        return (float) values.number("maxStepPx");
    }

    /** Sets {@link #getMaxStepPx}. */
    public void setMaxStepPx(float value) {
        set("maxStepPx", value);
    }

    /** The parameter {@link SofasParameters#flatSigmas}. */
    public float getFlatSigmas() {
        return (float) values.number("flatSigmas");
    }

    /** Sets {@link #getFlatSigmas}. */
    public void setFlatSigmas(float value) {
        set("flatSigmas", value);
    }

    /** The parameter {@link SofasParameters#stiffness}. */
    public float getStiffness() {
        return (float) values.number("stiffness");
    }

    /** Sets {@link #getStiffness}. */
    public void setStiffness(float value) {
        set("stiffness", value);
    }

    /** The parameter {@link SofasParameters#sharedScore}. */
    public float getSharedScore() {
        return (float) values.number("sharedScore");
    }

    /** Sets {@link #getSharedScore}. */
    public void setSharedScore(float value) {
        set("sharedScore", value);
    }

    /** Left end of its slider. */
    public float getMinSharedScore() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxSharedScore() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#foresight}. */
    public float getForesight() {
        return (float) values.number("foresight");
    }

    /** Sets {@link #getForesight}. */
    public void setForesight(float value) {
        set("foresight", value);
    }

    /** Left end of its slider. */
    public float getMinForesight() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxForesight() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#maxBendPx}. */
    public float getMaxBendPx() {
        return (float) values.number("maxBendPx");
    }

    /** Sets {@link #getMaxBendPx}. */
    public void setMaxBendPx(float value) {
        set("maxBendPx", value);
    }

    /** The parameter {@link SofasParameters#flatChange}. */
    public float getFlatChange() {
        return (float) values.number("flatChange");
    }

    /** Sets {@link #getFlatChange}. */
    public void setFlatChange(float value) {
        set("flatChange", value);
    }

    /** The parameter {@link SofasParameters#rotation}. */
    @Preferred
    public boolean isRotation() {
        return values.isOn("rotation");
    }

    /** Sets {@link #isRotation}. */
    public void setRotation(boolean value) {
        set("rotation", value);
    }

    /** The parameter {@link SofasParameters#changePx}. */
    public float getChangePx() {
        return (float) values.number("changePx");
    }

    /** Sets {@link #getChangePx}. */
    public void setChangePx(float value) {
        set("changePx", value);
    }

    /** The parameter {@link SofasParameters#changeGain}. */
    public float getChangeGain() {
        return (float) values.number("changeGain");
    }

    /** Sets {@link #getChangeGain}. */
    public void setChangeGain(float value) {
        set("changeGain", value);
    }

    /** The parameter {@link SofasParameters#bendPx}. */
    public float getBendPx() {
        return (float) values.number("bendPx");
    }

    /** Sets {@link #getBendPx}. */
    public void setBendPx(float value) {
        set("bendPx", value);
    }

    /** The parameter {@link SofasParameters#pathPx}. */
    public float getPathPx() {
        return (float) values.number("pathPx");
    }

    /** Sets {@link #getPathPx}. */
    public void setPathPx(float value) {
        set("pathPx", value);
    }

    /** The parameter {@link SofasParameters#flatDecay}. */
    public float getFlatDecay() {
        return (float) values.number("flatDecay");
    }

    /** Sets {@link #getFlatDecay}. */
    public void setFlatDecay(float value) {
        set("flatDecay", value);
    }

    /** The parameter {@link SofasParameters#maxShared}. */
    public float getMaxShared() {
        return (float) values.number("maxShared");
    }

    /** Sets {@link #getMaxShared}. */
    public void setMaxShared(float value) {
        set("maxShared", value);
    }

    /** The parameter {@link SofasParameters#maxTrackPlanes}. */
    @Preferred
    public int getMaxTrackPlanes() {
        return (int) values.number("maxTrackPlanes");
    }

    /** Sets {@link #getMaxTrackPlanes}. */
    public void setMaxTrackPlanes(int value) {
        set("maxTrackPlanes", value);
    }

    /** Left end of its slider. */
    public int getMinMaxTrackPlanes() {
        return 1;
    }

    /** Right end of its slider. */
    public int getMaxMaxTrackPlanes() {
        return 64;
    }

    /** The parameter {@link SofasParameters#minShare}. */
    public float getMinShare() {
        return (float) values.number("minShare");
    }

    /** Sets {@link #getMinShare}. */
    public void setMinShare(float value) {
        set("minShare", value);
    }

    /** Left end of its slider. */
    public float getMinMinShare() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxMinShare() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#crowdedShare}. */
    public float getCrowdedShare() {
        return (float) values.number("crowdedShare");
    }

    /** Sets {@link #getCrowdedShare}. */
    public void setCrowdedShare(float value) {
        set("crowdedShare", value);
    }

    /** Left end of its slider. */
    public float getMinCrowdedShare() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxCrowdedShare() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#returnShare}. */
    public float getReturnShare() {
        return (float) values.number("returnShare");
    }

    /** Sets {@link #getReturnShare}. */
    public void setReturnShare(float value) {
        set("returnShare", value);
    }

    /** Left end of its slider. */
    public float getMinReturnShare() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxReturnShare() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#mergeVelocity}. */
    public float getMergeVelocity() {
        return (float) values.number("mergeVelocity");
    }

    /** Sets {@link #getMergeVelocity}. */
    public void setMergeVelocity(float value) {
        set("mergeVelocity", value);
    }

    /** Left end of its slider. */
    public float getMinMergeVelocity() {
        return 0f;
    }

    /** Right end of its slider. */
    public float getMaxMergeVelocity() {
        return 1f;
    }

    /** The parameter {@link SofasParameters#mergeLoss}. */
    @Preferred
    public float getMergeLoss() {
        return (float) values.number("mergeLoss");
    }

    /** Sets {@link #getMergeLoss}. */
    public void setMergeLoss(float value) {
        set("mergeLoss", value);
    }

    /** The parameter {@link SofasParameters#mergeGapShare}. */
    public float getMergeGapShare() {
        return (float) values.number("mergeGapShare");
    }

    /** Sets {@link #getMergeGapShare}. */
    public void setMergeGapShare(float value) {
        set("mergeGapShare", value);
    }

    /** The parameter {@link SofasParameters#pairGapShare}. */
    public float getPairGapShare() {
        return (float) values.number("pairGapShare");
    }

    /** Sets {@link #getPairGapShare}. */
    public void setPairGapShare(float value) {
        set("pairGapShare", value);
    }
}
