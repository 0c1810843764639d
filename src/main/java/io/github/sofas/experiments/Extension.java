package io.github.sofas.experiments;

import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;

/**
 * An extension of the default preset, beyond the published method, that can be switched off. This class holds the only
 * list of the extensions. Every parameter that is a switch and on by default is an extension by itself. The numbers
 * named here are extensions, too: their least value switches off what they control.
 *
 * @param name the parameter's name, such as {@code rotation}
 */
record Extension(String name) {
    private static final List<String> OFF_AT_LEAST = List.of("evidence", "maxLifetimePx", "memoryPx");

    /** All extensions, in the order in which the parameters are declared. */
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

    /** The same parameters with the extension switched off. */
    SofasParameters off(SofasParameters parameters) {
        ParameterHandle handle = ParameterHandle.named(name);
        return handle.isSwitch() ? parameters.with(name, false) : parameters.with(name, handle.least(parameters));
    }
}
