package io.github.sofas.render;

/** One view of the sensor. */
public enum Panel {
    /** ON and OFF. */
    EVENTS("events"),
    /** Velocity of each event, by colour wheel. */
    FLOW("flow"),
    /** Segment of each event by colour, with ids and velocity arrows. */
    SEGMENTS("segments"),
    /** Where the track planes expect their events; only while SOFAS itself labels them. */
    CONTOURS("contours of the track planes"),
    /** The camera's grey-level frames. */
    GREY("grey-level frames");

    final String title;

    Panel(String title) {
        this.title = title;
    }

    @Override
    public String toString() {
        return name().toLowerCase(java.util.Locale.ROOT);
    }
}
