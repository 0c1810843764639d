package io.github.sofas.render;

/** A view of the sensor. A picture shows one or more of these views side by side. */
public enum Panel {
    /** Polarity of each event: ON or OFF. */
    EVENTS("events"),
    /** Velocity of each event, as a colour of the wheel. */
    FLOW("flow"),
    /** Segment of each event, as a colour, with ids and velocity arrows. */
    SEGMENTS("segments"),
    /** Contours: where the track planes expect their events. Only available while SOFAS itself labels the events. */
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
