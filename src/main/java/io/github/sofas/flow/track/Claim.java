package io.github.sofas.flow.track;

/** Why a track plane takes an event. */
enum Claim {
    /** The event lies on the contour of this plane alone. */
    OWN,
    /** The event lies on the contour of another plane, too, so that it shows nothing of the motion. */
    SHARED,
    /** The event lies on no contour, but where the structure was seen before, or in its box. It may be noise. */
    REMEMBERED,
    /**
     * The event does not lie on the contour, but comes into sight where the structure does: from beyond the border, or
     * from behind a body in front of the structure. The structure's texture continues from there.
     */
    APPEARING
}
