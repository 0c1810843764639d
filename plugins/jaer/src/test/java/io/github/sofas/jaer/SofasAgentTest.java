package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;

import java.util.Set;
import net.sf.jaer.eventprocessing.EventFilter;
import net.sf.jaer.eventprocessing.EventFilter2D;
import net.sf.jaer.util.JaerAllowedSubclasses;
import org.junit.Test;

public class SofasAgentTest {
    @Test
    public void filterIsAddedToWhatJaerAllows() {
        SofasAgent.premain(null, null);
        assertEquals(Set.of("net.sf.jaer.of.EventFilter2D", "io.github.sofas.jaer.SofasFlow"),
            JaerAllowedSubclasses.namesOrNullIfMissing(EventFilter2D.class));
        assertEquals(Set.of("net.sf.jaer.of.EventFilter", "io.github.sofas.jaer.SofasFlow"),
            JaerAllowedSubclasses.namesOrNullIfMissing(EventFilter.class));
    }
}
