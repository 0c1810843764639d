package io.github.sofas.jaer;

import io.github.sofas.flow.ParameterHandle;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes, at build time, the getters and setters by which jAER finds the parameters: one pair for each
 * {@link ParameterHandle}, and the ends of a slider where the range is narrow.
 */
public final class PropertiesGenerator {
    private static final double WIDEST_SLIDER = 100;
    /** Those to begin with: which speeds, how many structures, and how soon they are given up. */
    private static final List<String> SIMPLE = List.of("slowestPxPerS", "fastestPxPerS", "maxTrackPlanes", "minShare");
    private static final List<String> NAMES = ParameterHandle.all().stream().map(ParameterHandle::name).toList();

    private PropertiesGenerator() {
    }

    /**
     * Writes the source.
     *
     * @param args the folder of generated sources
     * @throws IOException where it cannot be written
     */
    public static void main(String[] args) throws IOException {
        Path file = Path.of(args[0]).resolve("io/github/sofas/jaer/GeneratedProperties.java");
        Files.createDirectories(file.getParent());
        Files.write(file, source().getBytes(StandardCharsets.UTF_8));
    }

    private static String source() {
        StringBuilder source = new StringBuilder("""
            package io.github.sofas.jaer;

            import net.sf.jaer.Preferred;
            import net.sf.jaer.chip.AEChip;

            /** Every parameter of SofasParameters as a property. Written by PropertiesGenerator at build time. */
            @SuppressWarnings("unchecked") // jAER overrides a typed method by a raw one
            public abstract class GeneratedProperties extends ParameterProperties {
                /** Reads the preferences. */
                protected GeneratedProperties(AEChip chip) {
                    super(chip);
                }
            """);
        for (ParameterHandle handle : ParameterHandle.all()) {
            property(handle, source);
        }
        return source.append("}\n").toString();
    }

    private static void property(ParameterHandle handle, StringBuilder source) {
        String type = handle.isSwitch() ? "boolean" : handle.isWhole() ? "int" : "float";
        String capital = capital(handle.name());
        String getter = (handle.isSwitch() ? "is" : "get") + capital;
        String value = handle.isSwitch() ? "isOn(\"" + handle.name() + "\")"
            : "(" + type + ") number(\"" + handle.name() + "\")";
        source.append("\n    /** The parameter ").append(handle.name()).append(": ")
            .append(handle.declaration().value()).append(". */\n")
            .append(SIMPLE.contains(handle.name()) ? "    @Preferred\n" : "");
        method(source, "public " + type + " " + getter + "()", "return " + value);
        source.append("\n    /** Sets {@link #").append(getter).append("}. */\n");
        method(source, "public void set" + capital + "(" + type + " value)", "set(\"" + handle.name() + "\", value)");
        if (hasSlider(handle)) {
            end(source, type, "getMin" + capital, "Left", handle.declaration().min());
            end(source, type, "getMax" + capital, "Right", handle.declaration().max());
        }
    }

    /** Not where the end of the slider would bear the name of another parameter. */
    private static boolean hasSlider(ParameterHandle handle) {
        return !handle.isSwitch() && handle.declaration().max() - handle.declaration().min() <= WIDEST_SLIDER
            && !NAMES.contains("min" + capital(handle.name())) && !NAMES.contains("max" + capital(handle.name()));
    }

    private static void end(StringBuilder source, String type, String name, String side, double value) {
        source.append("\n    /** ").append(side).append(" end of its slider. */\n");
        method(source, "public " + type + " " + name + "()", "return (" + type + ") " + value);
    }

    private static void method(StringBuilder source, String head, String statement) {
        source.append("    ").append(head).append(" {\n        ").append(statement).append(";\n    }\n");
    }

    private static String capital(String name) {
        return Character.toUpperCase(name.charAt(0)) + name.substring(1);
    }
}
