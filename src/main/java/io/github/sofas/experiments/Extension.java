package io.github.sofas.experiments;

import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;

/**
 * An extension of the default preset, beside the published method, that can be switched off. This is the only list of
 * them: every parameter that is a switch and on by default, by itself, and the numbers named here, whose least value
 * switches off what they are about.
 *
 * @param name the parameter's, as {@code rotation}
 */
record Extension(String name) {
    private static final List<String> OFF_AT_LEAST = List.of("evidence", "maxLifetimePx", "memoryPx");

    /** All, in the order in which parameters are declared. */
    static List<Extension> all() {
        SofasParameters defaults = SofasParameters.defaults();
        List<Extension> all = new ArrayList<>();
        for (ParameterHandle handle : ParameterHandle.all()) {
            boolean isOn = handle.isSwitch() && handle.isUsedBy(SofasParameters.Preset.DEFAULT)
                && Boolean.TRUE.equals(handle.get(defaults));
            if (isOn || OFF_AT_LEAST.contains(handle.name())) {
                all.add(new Extension(handle.name()));
            }
        }
        return all;
    }

    /** The same parameters with it switched off. */
    SofasParameters off(SofasParameters parameters) {
        ParameterHandle handle = ParameterHandle.named(name);
        return handle.isSwitch() ? parameters.with(name, false) : parameters.with(name, handle.least(parameters));
    }
}
