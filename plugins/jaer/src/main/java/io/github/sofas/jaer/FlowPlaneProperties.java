package io.github.sofas.jaer;

import io.github.sofas.flow.SofasParameters;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;

/** The parameters of the flow plane and its search as properties. */
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public abstract class FlowPlaneProperties extends ParameterProperties {
    /** Reads the preferences. */
    protected FlowPlaneProperties(AEChip chip) {
        super(chip);
    }

    /** The parameter {@link SofasParameters#flowProjections}. */
    public int getFlowProjections() {
        return (int) number("flowProjections");
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
        return (float) number("velocityScalePxPerS");
    }

    /** Sets {@link #getVelocityScalePxPerS}. */
    public void setVelocityScalePxPerS(float value) {
        set("velocityScalePxPerS", value);
    }

    /** The parameter {@link SofasParameters#rangeDeg}. */
    public float getRangeDeg() {
        return (float) number("rangeDeg");
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
        return (float) number("refinement");
    }

    /** Sets {@link #getRefinement}. */
    public void setRefinement(float value) {
        set("refinement", value);
    }

    /** The parameter {@link SofasParameters#cycles}. */
    public int getCycles() {
        return (int) number("cycles");
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
        return (int) number("constantEvents");
    }

    /** Sets {@link #getConstantEvents}. */
    public void setConstantEvents(int value) {
        set("constantEvents", value);
    }

    /** The parameter {@link SofasParameters#slowestPxPerS}. */
    @Preferred
    public float getSlowestPxPerS() {
        return (float) number("slowestPxPerS");
    }

    /** Sets {@link #getSlowestPxPerS}. */
    public void setSlowestPxPerS(float value) {
        set("slowestPxPerS", value);
    }

    /** The parameter {@link SofasParameters#fastestPxPerS}. */
    @Preferred
    public float getFastestPxPerS() {
        return (float) number("fastestPxPerS");
    }

    /** Sets {@link #getFastestPxPerS}. */
    public void setFastestPxPerS(float value) {
        set("fastestPxPerS", value);
    }

    /** The parameter {@link SofasParameters#flowTravelPx}. */
    public float getFlowTravelPx() {
        return (float) number("flowTravelPx");
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
        return (int) number("lifespanUs");
    }

    /** Sets {@link #getLifespanUs}. */
    public void setLifespanUs(int value) {
        set("lifespanUs", value);
    }

    /** The parameter {@link SofasParameters#thresholdSd}. */
    public float getThresholdSd() {
        return (float) number("thresholdSd");
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
        return (int) number("minEvents");
    }

    /** Sets {@link #getMinEvents}. */
    public void setMinEvents(int value) {
        set("minEvents", value);
    }

    /** The parameter {@link SofasParameters#evidence}. */
    public float getEvidence() {
        return (float) number("evidence");
    }

    /** Sets {@link #getEvidence}. */
    public void setEvidence(float value) {
        set("evidence", value);
    }

    /** The parameter {@link SofasParameters#slowestWithin}. */
    public float getSlowestWithin() {
        return (float) number("slowestWithin");
    }

    /** Sets {@link #getSlowestWithin}. */
    public void setSlowestWithin(float value) {
        set("slowestWithin", value);
    }
}
