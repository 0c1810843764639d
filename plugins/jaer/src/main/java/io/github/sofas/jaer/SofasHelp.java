package io.github.sofas.jaer;

/** The help page that jAER shows when the user asks for help with the filter. */
final class SofasHelp {
    /** The page, in HTML. */
    static final String TEXT = """
        <html>
        <h2>SOFAS</h2>
        <p>Gives every event its optical flow and the moving structure that it belongs to. Motion is looked for in the
        <i>flow plane</i>: events are projected along many velocities, and the one that brings them onto one contour is
        that of a structure. From then on a <i>track plane</i> follows the structure with its velocity, turn and
        growth.</p>
        <h3>What you see</h3>
        <ul>
        <li>a colour a segment, or a colour a direction of flow (<b>eventColours</b>)</li>
        <li>an arrow for each segment, as long as its way in a quarter of a second</li>
        <li>a label: id, velocity in px/s to the right and up, age; turn and growth where they are sure</li>
        </ul>
        <h3>What to change first</h3>
        <p>Tick <b>Simple</b> to see the few controls to begin with. <b>slowestPxPerS</b> and <b>fastestPxPerS</b>
        say which speeds are looked for, <b>minShare</b> how soon a structure that is no longer seen is given up,
        <b>maxTrackPlanes</b> how many there may be. <b>preset</b> PAPER is the method as published. <b>SetDefaults</b>
        brings all values of the preset back.</p>
        <h3>To files</h3>
        <p><b>WriteSession</b> writes flow, segments and tracks as CSV until it is switched off or the recording is
        rewound, <b>WriteCsv</b> those of the last packet.</p>
        <p>Beside Lucas-Kanade or local planes: keep <b>displayRawInput</b> on, and place SOFAS below them in the list,
        so that they do not paint over it.</p>
        </html>
        """;

    private SofasHelp() {
    }
}
