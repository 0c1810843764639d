package io.github.sofas.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Optional;
import java.util.stream.Stream;
import org.junit.Test;

public class MachineTest {
    @Test
    public void theProcessorIsTheFirstModelThatLinuxNames() {
        assertEquals(Optional.of("Intel(R) Xeon(R) @ 2.70GHz: 8"), Machine.cpu(Stream.of("processor\t: 0",
            "model\t\t: 106", "model name\t: Intel(R) Xeon(R) @ 2.70GHz: 8", "model name\t: another")));
        assertEquals(Optional.empty(), Machine.cpu(Stream.of("Processor : ARMv7")));
    }

    @Test
    public void thisMachineHasCoresAndMemory() {
        Machine here = Machine.here();
        assertFalse(here.cpu().isBlank());
        assertTrue(here.cores() >= 1);
        assertTrue(here.memoryBytes() > 0);
        assertTrue(here.maxHeapBytes() > 0);
    }
}
