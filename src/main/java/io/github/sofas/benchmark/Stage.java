package io.github.sofas.benchmark;

import java.util.Locale;

/** A stage on which a run spends its time. The stages are in the order in which an event passes through them. */
public enum Stage {
    /** Reading and decoding the recording. */
    DECODING,
    /** Finding the track plane of an event, and keeping the contours. */
    MATCHING,
    /** Measuring the velocity of track planes again. */
    RE_CENTRING,
    /** Projecting the events that no track plane takes, and searching for structures among them. */
    FLOW_PLANE,
    /** Formatting and writing the rows of the output. */
    OUTPUT,
    /** Everything else. */
    OTHER;

    private static final String ROOT = "io.github.sofas.";

    /** Name in JSON: {@code flow_plane}. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Name for people: {@code flow plane}. */
    public String title() {
        return this == RE_CENTRING ? "re-centring" : key().replace('_', ' ');
    }

    /**
     * Returns the stage to which a stack belongs.
     *
     * <p>Packages, classes and methods of the engine are named after the terms of the paper, and these names determine
     * the stage. A kernel that serves several stages thus counts for the stage that calls it. The start of a track
     * plane by the flow plane counts as work of the flow plane. All other frames of the engine count as matching:
     * matching has no frame of its own, because it is compiled into the loop over the events.
     */
    static Stage of(StackTraceElement[] stack) {
        Stage stage = OTHER;
        for (StackTraceElement frame : stack) {
            String type = frame.getClassName();
            if (type.startsWith(ROOT + "recording.")) {
                return DECODING;
            } else if (type.startsWith(ROOT + "export.")) {
                return OUTPUT;
            } else if (type.startsWith(ROOT + "flow.")) {
                if (type.startsWith(ROOT + "flow.search.") || type.contains("FlowPlane")) {
                    return FLOW_PLANE;
                } else if (frame.getMethodName().startsWith("recentre")) {
                    stage = RE_CENTRING;
                } else if (stage == OTHER) {
                    stage = MATCHING;
                }
            }
        }
        return stage;
    }
}
