package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.List;
import org.junit.Test;

public class MainTest {
    private static final List<String> COMMANDS = List.of("run", "live", "info", "evaluate", "simulate", "compare",
        "bench");

    @Test
    public void needsACommand() {
        Executed sofas = Executed.command();
        assertTrue(sofas.err, sofas.err.startsWith("Usage: sofas [-hV] "));
        for (String command : COMMANDS) {
            assertTrue(sofas.err, sofas.err.contains("\n  " + command + " "));
        }
        assertEquals("", sofas.out);
        assertEquals(2, sofas.exitCode);
    }

    @Test
    public void suggestsTheCommandThatWasMeant() {
        Executed sofas = Executed.command("rum");
        assertTrue(sofas.err, sofas.err.startsWith("Unmatched argument at index 0: 'rum'\nDid you mean: sofas run"));
        assertTrue(sofas.err, sofas.err.endsWith("\nTry 'sofas --help'.\n"));
        assertEquals(2, sofas.exitCode);
    }

    @Test
    public void tellsItsVersionAndThatOfJava() {
        Executed sofas = Executed.command("--version");
        assertEquals("sofas " + Version.text() + "\nJava " + Runtime.version() + "\n", sofas.out);
        assertTrue(Version.text(), Version.text().matches("\\d+\\.\\d+\\.\\d+(-SNAPSHOT)?"));
        assertEquals(0, sofas.exitCode);
    }

    @Test
    public void helpsWithEveryCommand() {
        Executed sofas = Executed.command("--help");
        assertEquals(0, sofas.exitCode);
        for (String command : COMMANDS) {
            assertTrue(sofas.out, sofas.out.contains("\n  " + command + " "));
            Executed help = Executed.command(command, "--help");
            assertTrue(help.out, help.out.startsWith("Usage: sofas " + command + " "));
            assertFalse("all options in the synopsis", help.out.contains("[--evidence"));
            assertEquals("", help.err);
            assertEquals(0, help.exitCode);
            assertEquals(help.out, Executed.command("help", command).out);
        }
    }

    /** The parser warns on the stream of the process itself, where no command's messages go. */
    @Test
    public void parserHasNothingToWarnOf() {
        PrintStream before = System.err;
        ByteArrayOutputStream warned = new ByteArrayOutputStream();
        try {
            System.setErr(new PrintStream(warned, true));
            Executed.command("--help");
            Executed.command("run", "--help-all");
            Executed.command("info", "recordings/hexagon.aedat");
        } finally {
            System.setErr(before);
        }
        assertEquals("", warned.toString());
    }

    @Test
    public void parametersAreShownByHelpAllOnly() {
        for (String command : new String[] {"run", "render", "live", "evaluate", "bench"}) {
            String help = Executed.command(command, "--help").out;
            assertFalse(help, help.contains("--lifetime-px"));
            assertFalse(help, help.contains("Algorithm parameters"));
            assertTrue(help, help.contains("--help-all"));
            String all = Executed.command(command, "--help-all").out;
            assertTrue(all, all.contains("--lifetime-px"));
            assertTrue(all, all.contains("Algorithm parameters"));
            assertTrue(all, all.startsWith(help.substring(0, help.indexOf('\n'))));
        }
    }

    @Test
    public void completesEveryCommandInTheShell() {
        Executed sofas = Executed.command("generate-completion");
        assertEquals(0, sofas.exitCode);
        assertTrue(sofas.out.startsWith("#!/usr/bin/env bash\n"));
        for (String command : COMMANDS) {
            assertTrue(command, sofas.out.contains("function _picocli_sofas_" + command + "()"));
        }
        assertTrue("presets", sofas.out.contains("\"paper\" \"default\""));
    }
}
