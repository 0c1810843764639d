package io.github.sofas.jaer;

import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventio.AEFileInputStreamInterface;
import net.sf.jaer.eventio.AEInputStream;
import net.sf.jaer.graphics.AEViewer;

/**
 * Notices when the reader of a recording starts again or is moved. The viewer resets its filters when it rewinds a
 * recording. But the readers of AEDAT 4 and of Metavision's files also rewind by themselves, at their end and at marks.
 * They report this on any thread, some of them while they are locked. Therefore this class only notes the report, for
 * the next packet.
 */
final class ReaderWatch implements PropertyChangeListener {
    private AEFileInputStreamInterface reader;
    private volatile boolean moved;

    /** Listens to the present reader of the viewer, and to no other. */
    void follow(AEChip chip) {
        AEViewer viewer = chip.getAeViewer();
        AEFileInputStreamInterface now = viewer == null || viewer.getAePlayer() == null ? null
            : viewer.getAePlayer().getAEInputStream();
        if (now != reader) {
            if (reader != null) {
                reader.getSupport().removePropertyChangeListener(this);
            }
            if (now != null) {
                now.getSupport().addPropertyChangeListener(this);
            }
            reader = now;
        }
    }

    @Override
    public void propertyChange(PropertyChangeEvent change) {
        String name = change.getPropertyName();
        if (AEInputStream.EVENT_REWOUND.equals(name) || AEInputStream.EVENT_REPOSITIONED.equals(name)) {
            moved = true;
        }
    }

    /** Whether the reader was moved since the last call. */
    boolean takeMoved() {
        boolean was = moved;
        moved = false;
        return was;
    }
}
