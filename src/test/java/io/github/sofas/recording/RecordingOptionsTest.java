package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import org.junit.Test;

/** What can be asked for without a recording. */
public class RecordingOptionsTest {
    private static void refuses(String message, String chip) {
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class,
                () -> RecordingOptions.defaults().withChip(chip));
        assertEquals(message, refused.getMessage());
    }

    @Test public void takesTheNameOfAChipOrASizeOrNone() {
        for (String chip : new String[] {"DVS128", "dvs128", "eu.seebetter.ini.chips.davis.DAVIS240C", "1x1",
            "1280X720", null}) {
            assertEquals(chip, RecordingOptions.defaults().withChip(chip).chip());
        }
    }

    @Test public void refusesAChipThatIsNone() {
        refuses("chip must name one of " + Chip.knownNames() + " or a size such as 240x180 but was DVS129", "DVS129");
        refuses("chip must name one of " + Chip.knownNames() + " or a size such as 240x180 but was ", "");
        refuses("chip 9999x1: sensor width must be between 1 and 1280 but was 9999", "9999x1");
        refuses("chip 1x0: sensor height must be between 1 and 720 but was 0", "1x0");
    }
}
