package io.github.sofas.experiments;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.Test;

public class ExtensionTest {
    private final SofasParameters defaults = SofasParameters.defaults();

    private static SofasParameters off(String name, SofasParameters parameters) {
        return Extension.all().stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow()
            .off(parameters);
    }

    @Test
    public void everySwitchThatIsOnIsOne() {
        List<String> names = Extension.all().stream().map(Extension::name).collect(Collectors.toList());
        for (ParameterHandle handle : ParameterHandle.all()) {
            if (handle.isSwitch() && Boolean.TRUE.equals(handle.get(defaults))) {
                assertTrue(handle.name(), names.contains(handle.name()));
            }
        }
    }

    @Test
    public void switchingOneOffLeavesTheOthersAsTheyAre() {
        SofasParameters without = off("rotation", defaults);
        assertFalse(without.track().rotation());
        assertEquals(defaults, without.with("rotation", true));
        assertEquals(0, off("memoryPx", defaults).track().memoryPx(), 0);
    }

    @Test
    public void aLifetimeThatDoesNotGrowIsTheShortest() {
        SofasParameters base = defaults.with("lifetimePx", 7);
        assertEquals(7, off("maxLifetimePx", base).track().maxLifetimePx(), 0);
    }
}
