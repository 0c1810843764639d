package io.github.sofas.benchmark;

import java.util.Locale;

/** What a run spends its time on, in the order in which an event meets it. */
public enum Stage {
    /** Reading and decoding the recording. */
    DECODING,
    /** Finding the track plane of an event, and keeping the contours. */
    MATCHING,
    /** Measuring the velocity of track planes anew. */
    RE_CENTRING,
    /** Projecting the events that no track plane takes, and finding structures among them. */
    FLOW_PLANE,
    /** Making and writing rows. */
    OUTPUT,
    /** What lies between these. */
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
     * The stage of a moment.
     *
     * <p>Goes by the names of the paper that classes and methods bear, so that a kernel that serves several stages
     * counts for the one that called it. A track plane that the flow plane starts is the flow plane's work. What
     * is left of the engine counts as matching: compiled into the loop over the events, matching has no frame of its
     * own.
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
