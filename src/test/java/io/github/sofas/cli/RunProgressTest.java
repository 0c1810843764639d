package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import org.junit.Test;

public class RunProgressTest {
    private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();
    private final StringWriter err = new StringWriter();

    /** Draws a bar of 10 MB on a terminal of 80 columns, after 7.5 MB with 3 of 4 events labelled. */
    private String drawn() {
        PrintStream stream = new PrintStream(terminal, true, StandardCharsets.UTF_8);
        try (RunProgress progress = new RunProgress(new PrintWriter(err), false,
            RunProgress.bar(new RunProgress.Line(stream, 80), 10_000_000))) {
            progress.add(7_500_000, 4_000_000, 3_000_000);
        }
        return terminal.toString(StandardCharsets.UTF_8);
    }

    @Test
    public void showsTheShareOfBytesAndOfEventsWithFlowOnEightyColumns() {
        String drawn = drawn();

        assertTrue(drawn, drawn.matches("(?s).*\\r *75% \\[=+ *\\] +7/10 MB .* 75\\.0 % with flow, \\d+ events/s.*"));
    }

    @Test
    public void barFitsEightyColumns() {
        for (String line : drawn().split("[\\r\\n]")) {
            String visible = line.replaceAll("\u001b\\[[0-9;]*[A-Za-z]", "");
            assertTrue(visible.length() + ": " + visible, visible.length() <= 80);
        }
    }

    @Test
    public void leavesNoLineBehind() {
        String drawn = drawn();

        assertFalse(drawn, drawn.contains("\n"));
        assertEquals("\r\u001b[K", err.toString());
    }

    @Test
    public void showsLinesWithoutControlCharactersWhereThereIsNoBar() {
        RunProgress progress = new RunProgress(new PrintWriter(err), false, null);

        progress.say("[edge.aedat] truncated");
        progress.close();

        assertEquals("[edge.aedat] truncated" + System.lineSeparator(), err.toString());
    }
}
