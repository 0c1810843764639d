package io.github.sofas.recording;

import io.github.sofas.event.SensorSize;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A sensor that recordings name: its size and how AEDAT 1 and 2 pack its addresses.
 *
 * @param name its name in recordings: the simple name of its class in jAER
 * @param jaerPackage package of that class, written into AEDAT 2 headers
 * @param sensor its pixel array
 * @param layout layout of its addresses in AEDAT 1 and 2
 */
public record Chip(String name, String jaerPackage, SensorSize sensor, AddressLayout layout) {

    /** How an address of AEDAT 1 and 2 holds pixel and polarity. */
    public enum AddressLayout {
        /** 16 bits: polarity in bit 0, x from bit 1, y from bit 8. */
        DVS128,
        /** 32 bits: polarity in bit 11, x from bit 12, y from bit 22. */
        DAVIS
    }

    private static final String RETINA = "ch.unizh.ini.jaer.chip.retina";
    private static final String DAVIS = "eu.seebetter.ini.chips.davis";

    /** Sizes and class names from jAER (SensorsINI/jaer a1db449505). */
    private static final List<Chip> KNOWN = List.of(
            new Chip("DVS128", RETINA, new SensorSize(128, 128), AddressLayout.DVS128),
            new Chip("Tmpdiff128", RETINA, new SensorSize(128, 128), AddressLayout.DVS128),
            davis("DAVIS240A", 240, 180),
            davis("DAVIS240B", 240, 180),
            davis("DAVIS240C", 240, 180),
            davis("DVS240", 240, 180),
            davis("Davis346red", 346, 260),
            davis("Davis346blue", 346, 260),
            davis("Davis346B", 346, 260),
            davis("Davis346cBSI", 346, 260),
            davis("Davis346Zynq", 346, 260),
            davis("Davis128", 128, 128),
            davis("Davis640", 640, 480));

    /**
     * Names of whole families, as cameras and AEDAT 3 and 4 use them, each with the member that stands for it. The
     * members of a family differ in nothing that is read here.
     */
    private static final Map<String, String> FAMILIES = Map.of("davis240", "davis240c", "davis346", "davis346red");

    private static Chip davis(String name, int width, int height) {
        return new Chip(name, DAVIS, new SensorSize(width, height), AddressLayout.DAVIS);
    }

    /** {@return all known chips, in the order in which help texts list them} */
    public static List<Chip> known() {
        return KNOWN;
    }

    /** {@return the names of all known chips, separated by commas, as messages list them} */
    public static String knownNames() {
        StringBuilder names = new StringBuilder();
        for (Chip chip : KNOWN) {
            names.append(names.length() == 0 ? "" : ", ").append(chip.name);
        }
        return names.toString();
    }

    /**
     * {@return the known chip with a name; empty where there is none}
     *
     * @param name with or without its package, in upper or lower case; {@code DAVIS240} and {@code DAVIS346} stand for
     *     DAVIS240C and Davis346red
     */
    public static Optional<Chip> named(String name) {
        String simple = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        String member = FAMILIES.getOrDefault(simple, simple);
        return KNOWN.stream().filter(chip -> chip.name.toLowerCase(Locale.ROOT).equals(member)).findFirst();
    }

    /** {@return the name with its package, as AEDAT 2 headers hold it} */
    public String className() {
        return jaerPackage + "." + name;
    }
}
