package io.github.sofas.flow.track;

/** Why a track plane takes an event. */
enum Claim {
    /** It lies on this contour alone. */
    OWN,
    /** It lies on another's contour, too: it shows nothing of the motion. */
    SHARED,
    /** It lies on no contour, but where the structure was seen, or in its box: it may be noise. */
    REMEMBERED,
    /**
     * It lies not on its contour, but comes into sight where the structure does, from beyond the border or from behind
     * what moves before it, and the structure's texture goes on from there.
     */
    APPEARING
}
