package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import org.junit.Test;

public class BiasesTest {
    private static final Biases DAVIS240 = Biases.defaults(CameraModel.DAVIS240C);

    private static int value(Biases biases, String name) {
        return biases.all().stream().filter(bias -> bias.name().equals(name)).findFirst().orElseThrow().value();
    }

    private static String refusal(Biases biases, String name, String text) {
        return assertThrows(IllegalArgumentException.class, () -> biases.with(name, text)).getMessage();
    }

    @Test
    public void hasEveryBiasOfEachCamera() {
        assertEquals(22, DAVIS240.all().size());
        assertEquals(28, Biases.defaults(CameraModel.DAVIS346).all().size());
        assertEquals(12, Biases.defaults(CameraModel.DVS128).all().size());
    }

    @Test
    public void changesOneAndLeavesTheOthers() {
        Biases changed = DAVIS240.with("diffbn", "0x1234");
        assertEquals(0x1234, value(changed, "DiffBn"));
        assertEquals(0x427F, value(DAVIS240, "DiffBn"));
        assertEquals(DAVIS240.all().subList(1, 22), changed.all().subList(1, 22));
    }

    @Test
    public void takesCoarseAndFineAndKeepsTheFlags() {
        // 5 << 12 | 32 << 4, flags D of 0x23AD
        assertEquals(0x520D, value(DAVIS240.with("PrBp", " 5  32 "), "PrBp"));
    }

    @Test
    public void takesPlainNumbersOfADvs128() {
        assertEquals(16_777_215, value(Biases.defaults(CameraModel.DVS128).with("pr", "16777215"), "pr"));
    }

    @Test
    public void refusesWhatTheCameraCannotTake() {
        String davisRule = "DiffBn must be a number from 0 to 65535, or coarse (0 to 7) and fine (0 to 255), but was ";
        assertEquals(davisRule + "\"65536\"", refusal(DAVIS240, "DiffBn", "65536"));
        assertEquals(davisRule + "\"8 0\"", refusal(DAVIS240, "DiffBn", "8 0"));
        assertEquals("pr must be a number from 0 to 16777215 but was \"1 2\"",
            refusal(Biases.defaults(CameraModel.DVS128), "pr", "1 2"));
        assertEquals("pr must be a number from 0 to 16777215 but was \"much\"",
            refusal(Biases.defaults(CameraModel.DVS128), "pr", "much"));
        assertEquals("unknown bias \"nope\"; this camera's are cas, injGnd, reqPd, puX, diffOff, req, refr, puY, "
            + "diffOn, diff, foll, pr", refusal(Biases.defaults(CameraModel.DVS128), "nope", "1"));
    }
}
