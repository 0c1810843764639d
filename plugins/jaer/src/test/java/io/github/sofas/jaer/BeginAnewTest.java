package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import java.beans.PropertyChangeSupport;
import java.util.List;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.eventprocessing.EventFilter;
import net.sf.jaer.graphics.AEViewer;
import org.junit.Before;
import org.junit.Test;

/** Readers of AEDAT 4 and of Metavision's files begin again by themselves, and tell only those that listen to them. */
public class BeginAnewTest {
    private static final List<EventBatch> FILM = Packets.film();

    private final AEChip chip = new AEChip();
    private final PropertyChangeSupport reader = new PropertyChangeSupport(this);
    private SofasFlow filter;

    @Before
    public void openARecording() {
        EventFilter.PREFERENCES.clear();
        chip.sizeX = Packets.SENSOR.width();
        chip.sizeY = Packets.SENSOR.height();
        chip.viewer = new AEViewer();
        chip.viewer.player.in = () -> reader;
        filter = new SofasFlow(chip);
        filter.initFilter();
        filter.setFilterEnabled(true);
        filter.setEngineAwaited(true);
    }

    private List<String> show() {
        filter.good.clear();
        for (EventBatch batch : FILM) {
            filter.filterPacket(Packets.of(batch));
        }
        return List.copyOf(filter.good);
    }

    @Test
    public void readerThatBeginsAgainIsHeard() {
        List<String> first = show();
        reader.firePropertyChange("rewound", 12_000, 0);
        assertTrue(first.equals(show()));
    }

    @Test
    public void readerThatIsMovedIsHeard() {
        List<String> first = show();
        reader.firePropertyChange("respositioned", 12_000, 0);
        assertTrue(first.equals(show()));
    }

    @Test
    public void everyReaderIsHeardOnceAndOnlyWhileItIsRead() {
        show();
        show();
        assertEquals(1, reader.getPropertyChangeListeners().length);
        PropertyChangeSupport next = new PropertyChangeSupport(this);
        chip.viewer.player.in = () -> next;
        show();
        assertEquals(0, reader.getPropertyChangeListeners().length);
        assertEquals(1, next.getPropertyChangeListeners().length);
    }

    @Test
    public void cameraHasNoReader() {
        chip.viewer.player.in = null;
        assertEquals(12_000, show().size());
    }
}
