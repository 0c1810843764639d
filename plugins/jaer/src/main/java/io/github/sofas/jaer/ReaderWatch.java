package io.github.sofas.jaer;

import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventio.AEFileInputStreamInterface;
import net.sf.jaer.eventio.AEInputStream;
import net.sf.jaer.graphics.AEViewer;

/**
 * Hears when the reader of a recording begins again or is moved. The viewer resets its filters where it rewinds a
 * recording, but the readers of AEDAT 4 and of Metavision's files also do so by themselves, at their end and at marks.
 * They tell it by any thread, some while they are locked: so what they say is only noted, for the next packet.
 */
final class ReaderWatch implements PropertyChangeListener {
    private AEFileInputStreamInterface reader;
    private volatile boolean moved;

    /** Listens to the reader that the viewer has now, and to no other. */
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

    /** Whether it was moved since this was asked last. */
    boolean takeMoved() {
        boolean was = moved;
        moved = false;
        return was;
    }
}
