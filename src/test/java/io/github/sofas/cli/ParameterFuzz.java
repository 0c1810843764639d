package io.github.sofas.cli;

import io.github.sofas.FuzzRules;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Command lines and config files: whatever they say, they are refused in one message, or their parameters are taken.
 * The recording is not there, so that nothing is run.
 */
public final class ParameterFuzz {
    private static final Path CONFIG = FuzzRules.file(".properties");
    private static final Map<String, List<String>> COMMANDS = Map.of(
        "run", List.of("run", "no such recording", "--out", "no such folder"),
        "render", List.of("render", "no such recording", "--out", "no such folder"),
        "evaluate", List.of("evaluate", "no such recording", "--truth", "no such truth"));

    private ParameterFuzz() {
    }

    /** Called by the fuzzer: a config file up to the first zero, then arguments between zeros, a command the first. */
    public static void fuzzerTestOneInput(byte[] data) {
        String[] parts = new String(data, StandardCharsets.ISO_8859_1).split("\0", -1);
        List<String> command = COMMANDS.getOrDefault(parts.length > 1 ? parts[1] : "", COMMANDS.get("run"));
        List<String> arguments = new ArrayList<>(command);
        FuzzRules.write(CONFIG, parts[0].getBytes(StandardCharsets.ISO_8859_1));
        if (!parts[0].isEmpty()) {
            arguments.addAll(List.of("--config", CONFIG.toString()));
        }
        for (int i = parts.length > 1 && COMMANDS.containsKey(parts[1]) ? 2 : 1; i < parts.length; i++) {
            arguments.add(parts[i]);
        }
        Executed run = Executed.command(arguments.toArray(new String[0]));
        boolean asksForHelp = run.exitCode == 0 && !run.out.isEmpty();
        FuzzRules.require(run.exitCode == 2 || asksForHelp, "exit code " + run.exitCode + ": " + run.err);
        FuzzRules.require(run.err.chars().noneMatch(c -> Character.isISOControl(c) && c != '\n'),
            "a message holds control characters: " + run.err);
    }

    /** Valid inputs to start from. */
    public static List<byte[]> seeds() {
        List<byte[]> seeds = new ArrayList<>();
        for (String text : List.of("lifetime-px=6\nmax-track-planes = 3\n# no more\nrotation: false\n", "",
            "evidence=1e-2|--preset|paper|--min-events=20", "|--lifetime-px|5|--max-lifetime-px|4",
            "|--method|lucas-kanade|--derivative|central-difference", "|--chip|DAVIS240C|--strict|-j|2",
            "memory\\u002dpx=6", "|--rotation|true|--quiet|--force|--name-with-extension",
            "|evaluate|--skip-first-share|0.5", "|render|--panels|flow,segments|--crop|1,2,30,40|--slow|10",
            "|render|--exposure|20ms|--from|0.5|--every|5000|--theme|light")) {
            seeds.add(text.replace('|', '\0').getBytes(StandardCharsets.ISO_8859_1));
        }
        return seeds;
    }
}
