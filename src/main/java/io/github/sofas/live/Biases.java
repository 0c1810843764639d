package io.github.sofas.live;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The bias currents of a camera, which determine its thresholds and speed. Immutable. The names are libcaer's.
 *
 * <p>A bias of a DAVIS is a word of 16 bits: the coarse current in bits 14 to 12, the fine current in bits 11 to 4,
 * then four flags (8 normal current, 4 normal type, 2 sex N, 1 enabled). A bias of a DVS128 is a plain number of 24
 * bits.
 */
public final class Biases {
    private static final int DAVIS_MAX = 0xFFFF;
    private static final int DVS128_MAX = 0xFFFFFF;
    private static final int COARSE_MAX = 7;
    private static final int COARSE_SHIFT = 12;
    private static final int FINE_MAX = 255;
    private static final int FINE_SHIFT = 4;
    private static final int FLAGS_MASK = 0x800F;

    private static final Biases DAVIS240 = new Biases(DAVIS_MAX, List.of(
        new Bias("DiffBn", 0, 0x427F), new Bias("OnBn", 1, 0x5FFF), new Bias("OffBn", 2, 0x400F),
        new Bias("ApsCasEpc", 3, 0x5B9B), new Bias("DiffCasBnc", 4, 0x573B), new Bias("ApsROSFBn", 5, 0x6DBF),
        new Bias("LocalBufBn", 6, 0x5A4F), new Bias("PixInvBn", 7, 0x690F), new Bias("PrBp", 8, 0x23AD),
        new Bias("PrSFBp", 9, 0x110D), new Bias("RefrBp", 10, 0x419D), new Bias("AEPdBn", 11, 0x65BF),
        new Bias("LcolTimeoutBn", 12, 0x531F), new Bias("AEPuXBp", 13, 0x450D), new Bias("AEPuYBp", 14, 0x798D),
        new Bias("IFThrBn", 15, 0x5FFF), new Bias("IFRefrBn", 16, 0x5FFF), new Bias("PadFollBn", 17, 0x7D7F),
        new Bias("ApsOverflowLevelBn", 18, 0x6FDF), new Bias("BiasBuffer", 19, 0x5FEF), new Bias("SSP", 20, 0x8410),
        new Bias("SSN", 21, 0x8410)));

    private static final Biases DAVIS346 = new Biases(DAVIS_MAX, List.of(
        new Bias("ApsOverflowLevel", 0, 0x019B), new Bias("ApsCas", 1, 0x0195), new Bias("AdcRefHigh", 2, 0x01E0),
        new Bias("AdcRefLow", 3, 0x01C1), new Bias("AdcTestVoltage", 4, 0x01D5), new Bias("LocalBufBn", 8, 0x5A4F),
        new Bias("PadFollBn", 9, 0x7D7E), new Bias("DiffBn", 10, 0x427F), new Bias("OnBn", 11, 0x5FFF),
        new Bias("OffBn", 12, 0x401F), new Bias("PixInvBn", 13, 0x690F), new Bias("PrBp", 14, 0x23AD),
        new Bias("PrSFBp", 15, 0x110D), new Bias("RefrBp", 16, 0x419D), new Bias("ReadoutBufBp", 17, 0x614D),
        new Bias("ApsROSFBn", 18, 0x6DBF), new Bias("AdcCompBp", 19, 0x514D), new Bias("ColSelLowBn", 20, 0x001F),
        new Bias("DacBufBp", 21, 0x63CD), new Bias("LcolTimeoutBn", 22, 0x531F), new Bias("AEPdBn", 23, 0x65BF),
        new Bias("AEPuXBp", 24, 0x450D), new Bias("AEPuYBp", 25, 0x798D), new Bias("IFRefrBn", 26, 0x5FFF),
        new Bias("IFThrBn", 27, 0x5FFF), new Bias("BiasBuffer", 34, 0x5FEF), new Bias("SSP", 35, 0x8410),
        new Bias("SSN", 36, 0x8410)));

    private static final Biases DVS128 = new Biases(DVS128_MAX, List.of(
        new Bias("cas", 0, 1992), new Bias("injGnd", 1, 1108364), new Bias("reqPd", 2, 16777215),
        new Bias("puX", 3, 8159221), new Bias("diffOff", 4, 132), new Bias("req", 5, 309590),
        new Bias("refr", 6, 969), new Bias("puY", 7, 16777215), new Bias("diffOn", 8, 209996),
        new Bias("diff", 9, 13125), new Bias("foll", 10, 271), new Bias("pr", 11, 217)));

    private final int max;
    private final List<Bias> all;

    /**
     * One bias.
     *
     * @param name name as in libcaer
     * @param address number of the bias in the camera
     * @param value value as sent to the camera
     */
    record Bias(String name, int address, int value) {
    }

    private Biases(int max, List<Bias> all) {
        this.max = max;
        this.all = all;
    }

    /**
     * {@return the default biases of a kind of camera}
     *
     * @param model kind of camera
     */
    public static Biases defaults(CameraModel model) {
        return switch (model) {
            case DAVIS240C -> DAVIS240;
            case DAVIS346 -> DAVIS346;
            case DVS128 -> DVS128;
        };
    }

    /** All biases, in the order in which they are sent. */
    List<Bias> all() {
        return Collections.unmodifiableList(all);
    }

    /** {@return the names of all biases, separated by commas} */
    public String names() {
        return String.join(", ", all.stream().map(Bias::name).toList());
    }

    /**
     * {@return these biases with another value of one of them}
     *
     * @param name name of the bias, in upper or lower case
     * @param text a number, decimal or hexadecimal with 0x in front; or, for a DAVIS, coarse and fine current (0 to 7
     *     and 0 to 255) separated by a blank, which leave the flags as they are
     * @throws IllegalArgumentException if the camera has no such bias, or if the value is outside its range
     */
    public Biases with(String name, String text) {
        List<Bias> changed = new ArrayList<>(all);
        for (int i = 0; i < changed.size(); i++) {
            Bias bias = changed.get(i);
            if (bias.name.equalsIgnoreCase(name)) {
                changed.set(i, new Bias(bias.name, bias.address, value(bias, text)));
                return new Biases(max, changed);
            }
        }
        throw new IllegalArgumentException("unknown bias \"" + name + "\"; this camera's are " + names());
    }

    private int value(Bias bias, String text) {
        String[] parts = text.strip().split("\\s+");
        try {
            if (parts.length == 2 && max == DAVIS_MAX) {
                int coarse = Integer.decode(parts[0]);
                int fine = Integer.decode(parts[1]);
                if (coarse >= 0 && coarse <= COARSE_MAX && fine >= 0 && fine <= FINE_MAX) {
                    return bias.value & FLAGS_MASK | coarse << COARSE_SHIFT | fine << FINE_SHIFT;
                }
            } else if (parts.length == 1) {
                int value = Integer.decode(parts[0]);
                if (value >= 0 && value <= max) {
                    return value;
                }
            }
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(rule(bias, text), e);
        }
        throw new IllegalArgumentException(rule(bias, text));
    }

    private String rule(Bias bias, String text) {
        return bias.name + " must be a number from 0 to " + max
            + (max == DAVIS_MAX ? ", or coarse (0 to 7) and fine (0 to 255)," : "") + " but was \"" + text + "\"";
    }
}
