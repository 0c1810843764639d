package io.github.sofas.jaer;

import io.github.sofas.flow.SofasParameters;
import net.sf.jaer.Preferred;
import net.sf.jaer.chip.AEChip;

/** The parameters of the track planes as properties. */
@SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
public abstract class TrackPlaneProperties extends FlowPlaneProperties {
    /** Reads the preferences. */
    protected TrackPlaneProperties(AEChip chip) {
        super(chip);
    }

    /** The parameter {@link SofasParameters#lifetimePx}. */
    @Preferred
    public float getLifetimePx() {
        return (float) number("lifetimePx");
    }

    /** Sets {@link #getLifetimePx}. */
    public void setLifetimePx(float value) {
        set("lifetimePx", value);
    }

    /** The parameter {@link SofasParameters#maxLifetimePx}. */
    @Preferred
    public float getMaxLifetimePx() {
        return (float) number("maxLifetimePx");
    }

    /** Sets {@link #getMaxLifetimePx}. */
    public void setMaxLifetimePx(float value) {
        set("maxLifetimePx", value);
    }

    /** The parameter {@link SofasParameters#maxLifetimeUs}. */
    public int getMaxLifetimeUs() {
        return (int) number("maxLifetimeUs");
    }

    /** Sets {@link #getMaxLifetimeUs}. */
    public void setMaxLifetimeUs(int value) {
        set("maxLifetimeUs", value);
    }

    /** The parameter {@link SofasParameters#steadyPx}. */
    public float getSteadyPx() {
        return (float) number("steadyPx");
    }

    /** Sets {@link #getSteadyPx}. */
    public void setSteadyPx(float value) {
        set("steadyPx", value);
    }

    /** The parameter {@link SofasParameters#hitShare}. */
    public float getHitShare() {
        return (float) number("hitShare");
    }

    /** Sets {@link #getHitShare}. */
    public void setHitShare(float value) {
        set("hitShare", value);
    }

    /** The parameter {@link SofasParameters#minPerturbationDeg}. */
    public float getMinPerturbationDeg() {
        return (float) number("minPerturbationDeg");
    }

    /** Sets {@link #getMinPerturbationDeg}. */
    public void setMinPerturbationDeg(float value) {
        set("minPerturbationDeg", value);
    }

    /** The parameter {@link SofasParameters#maxPerturbationDeg}. */
    public float getMaxPerturbationDeg() {
        return (float) number("maxPerturbationDeg");
    }

    /** Sets {@link #getMaxPerturbationDeg}. */
    public void setMaxPerturbationDeg(float value) {
        set("maxPerturbationDeg", value);
    }

    /** The parameter {@link SofasParameters#contourThreshold}. */
    public int getContourThreshold() {
        return (int) number("contourThreshold");
    }

    /** Sets {@link #getContourThreshold}. */
    public void setContourThreshold(int value) {
        set("contourThreshold", value);
    }

    /** The parameter {@link SofasParameters#contourShare}. */
    @Preferred
    public float getContourShare() {
        return (float) number("contourShare");
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
        return (float) number("memoryPx");
    }

    /** Sets {@link #getMemoryPx}. */
    public void setMemoryPx(float value) {
        set("memoryPx", value);
    }

    /** The parameter {@link SofasParameters#maxMemoryUs}. */
    public int getMaxMemoryUs() {
        return (int) number("maxMemoryUs");
    }

    /** Sets {@link #getMaxMemoryUs}. */
    public void setMaxMemoryUs(int value) {
        set("maxMemoryUs", value);
    }

    /** The parameter {@link SofasParameters#voteCellPx}. */
    public float getVoteCellPx() {
        return (float) number("voteCellPx");
    }

    /** Sets {@link #getVoteCellPx}. */
    public void setVoteCellPx(float value) {
        set("voteCellPx", value);
    }

    /** The parameter {@link SofasParameters#sampleEvents}. */
    public int getSampleEvents() {
        return (int) number("sampleEvents");
    }

    /** Sets {@link #getSampleEvents}. */
    public void setSampleEvents(int value) {
        set("sampleEvents", value);
    }

    /** The parameter {@link SofasParameters#sampleDensity}. */
    public float getSampleDensity() {
        return (float) number("sampleDensity");
    }

    /** Sets {@link #getSampleDensity}. */
    public void setSampleDensity(float value) {
        set("sampleDensity", value);
    }

    /** The parameter {@link SofasParameters#neighbourLoss}. */
    public float getNeighbourLoss() {
        return (float) number("neighbourLoss");
    }

    /** Sets {@link #getNeighbourLoss}. */
    public void setNeighbourLoss(float value) {
        set("neighbourLoss", value);
    }

    /** The parameter {@link SofasParameters#minStepPx}. */
    public float getMinStepPx() {
        return (float) number("minStepPx");
    }

    /** Sets {@link #getMinStepPx}. */
    public void setMinStepPx(float value) {
        set("minStepPx", value);
    }

    /** The parameter {@link SofasParameters#maxStepPx}. */
    public float getMaxStepPx() {
        return (float) number("maxStepPx");
    }

    /** Sets {@link #getMaxStepPx}. */
    public void setMaxStepPx(float value) {
        set("maxStepPx", value);
    }

    /** The parameter {@link SofasParameters#flatSigmas}. */
    public float getFlatSigmas() {
        return (float) number("flatSigmas");
    }

    /** Sets {@link #getFlatSigmas}. */
    public void setFlatSigmas(float value) {
        set("flatSigmas", value);
    }

    /** The parameter {@link SofasParameters#stiffness}. */
    public float getStiffness() {
        return (float) number("stiffness");
    }

    /** Sets {@link #getStiffness}. */
    public void setStiffness(float value) {
        set("stiffness", value);
    }

    /** The parameter {@link SofasParameters#sharedScore}. */
    public float getSharedScore() {
        return (float) number("sharedScore");
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
        return (float) number("foresight");
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
        return (float) number("maxBendPx");
    }

    /** Sets {@link #getMaxBendPx}. */
    public void setMaxBendPx(float value) {
        set("maxBendPx", value);
    }

    /** The parameter {@link SofasParameters#flatChange}. */
    public float getFlatChange() {
        return (float) number("flatChange");
    }

    /** Sets {@link #getFlatChange}. */
    public void setFlatChange(float value) {
        set("flatChange", value);
    }

    /** The parameter {@link SofasParameters#rotation}. */
    @Preferred
    public boolean isRotation() {
        return isOn("rotation");
    }

    /** Sets {@link #isRotation}. */
    public void setRotation(boolean value) {
        set("rotation", value);
    }

    /** The parameter {@link SofasParameters#changePx}. */
    public float getChangePx() {
        return (float) number("changePx");
    }

    /** Sets {@link #getChangePx}. */
    public void setChangePx(float value) {
        set("changePx", value);
    }

    /** The parameter {@link SofasParameters#changeGain}. */
    public float getChangeGain() {
        return (float) number("changeGain");
    }

    /** Sets {@link #getChangeGain}. */
    public void setChangeGain(float value) {
        set("changeGain", value);
    }

    /** The parameter {@link SofasParameters#bendPx}. */
    public float getBendPx() {
        return (float) number("bendPx");
    }

    /** Sets {@link #getBendPx}. */
    public void setBendPx(float value) {
        set("bendPx", value);
    }

    /** The parameter {@link SofasParameters#flatDecay}. */
    public float getFlatDecay() {
        return (float) number("flatDecay");
    }

    /** Sets {@link #getFlatDecay}. */
    public void setFlatDecay(float value) {
        set("flatDecay", value);
    }

    /** The parameter {@link SofasParameters#maxShared}. */
    public float getMaxShared() {
        return (float) number("maxShared");
    }

    /** Sets {@link #getMaxShared}. */
    public void setMaxShared(float value) {
        set("maxShared", value);
    }

    /** The parameter {@link SofasParameters#maxTrackPlanes}. */
    @Preferred
    public int getMaxTrackPlanes() {
        return (int) number("maxTrackPlanes");
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
        return (float) number("minShare");
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

    /** The parameter {@link SofasParameters#mergeVelocity}. */
    public float getMergeVelocity() {
        return (float) number("mergeVelocity");
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
        return (float) number("mergeLoss");
    }

    /** Sets {@link #getMergeLoss}. */
    public void setMergeLoss(float value) {
        set("mergeLoss", value);
    }

    /** The parameter {@link SofasParameters#mergeGapShare}. */
    public float getMergeGapShare() {
        return (float) number("mergeGapShare");
    }

    /** Sets {@link #getMergeGapShare}. */
    public void setMergeGapShare(float value) {
        set("mergeGapShare", value);
    }

}
