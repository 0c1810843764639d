package io.github.sofas.flow.track;

/** Why a track plane takes an event. */
enum Claim {
    /** It lies on this contour alone. */
    OWN,
    /** It lies on another's contour, too: it shows nothing of the motion. */
    SHARED,
    /** It lies where the structure was seen, and no event was near of late: it may be noise. */
    REMEMBERED
}
