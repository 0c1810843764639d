package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import picocli.CommandLine;

/** Holds what README and the pages of docs say of the program against the program: options, defaults, figures. */
public class DocumentationTest {
    private static final Pattern OPTION = Pattern.compile("(?<![\\w-])--[a-z][a-z0-9-]*");
    /** A command as typed, in a text or a block: its name and what follows on the line or up to the mark's end. */
    private static final Pattern TYPED = Pattern.compile("(?:\\./)?sofas ([a-z]+)\\b([^`\n]*)");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private static Map<Path, String> pages() throws IOException {
        Map<Path, String> pages = new java.util.TreeMap<>();
        List<Path> files = new ArrayList<>(List.of(Path.of("README.md")));
        if (Files.isDirectory(Path.of("docs"))) {
            try (Stream<Path> docs = Files.list(Path.of("docs"))) {
                docs.filter(page -> page.toString().endsWith(".md")).forEach(files::add);
            }
        }
        for (Path file : files) {
            pages.put(file, Files.readString(file));
        }
        return pages;
    }

    private static List<String> all(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(MatchResult::group).toList();
    }

    @Test
    public void everyOptionThatIsNamedExists() throws Exception {
        Map<String, CommandLine> commands = new SofasCommand().commandLine().getSubcommands();
        Set<String> known = new HashSet<>(Set.of("--help", "--version"));
        commands.values().forEach(command -> known.addAll(command.getCommandSpec().optionsMap().keySet()));
        for (Map.Entry<Path, String> page : pages().entrySet()) {
            // not the options of other programs
            for (String option : all(OPTION, page.getValue().replaceAll("`sudo [^`]*`", ""))) {
                assertTrue(page.getKey() + " names " + option, known.contains(option));
            }
            Matcher typed = TYPED.matcher(page.getValue());
            while (typed.find()) {
                CommandLine command = commands.get(typed.group(1));
                if (command == null || typed.start() > 0 && page.getValue().charAt(typed.start() - 1) == '/') {
                    continue;
                }
                for (String option : all(OPTION, typed.group(2))) {
                    assertTrue(page.getKey() + ": " + typed.group(),
                        command.getCommandSpec().optionsMap().containsKey(option));
                }
            }
        }
    }

    /** The table with the columns option, default and paper. */
    @Test
    public void everyDefaultThatIsNamedIsTheProgramS() throws Exception {
        Map<String, Object> defaults = ParameterOptions.asMap(SofasParameters.defaults());
        Map<String, Object> paper = ParameterOptions.asMap(SofasParameters.paper());
        int held = 0;
        for (Map.Entry<Path, String> page : pages().entrySet()) {
            boolean isTable = false;
            for (String line : page.getValue().lines().toList()) {
                isTable = line.matches("\\| *option *\\| *default *\\| *paper *\\|.*")
                    || isTable && line.startsWith("|");
                List<String> options = all(OPTION, line.startsWith("|") ? line.split("\\|")[1] : "");
                if (isTable && !options.isEmpty()) {
                    held += assertValues(page.getKey() + ": " + line, options, line.split("\\|")[2], defaults);
                    assertValues(page.getKey() + ": " + line, options, line.split("\\|")[3], paper);
                }
            }
        }
        assertTrue(held + " defaults", held >= 5);
    }

    private static int assertValues(String where, List<String> options, String cell, Map<String, Object> values) {
        if (cell.isBlank()) {
            return 0;
        }
        String[] named = cell.strip().split(" *, *");
        for (int i = 0; i < options.size(); i++) {
            String value = named[named.length == 1 ? 0 : i];
            Object actual = values.get(options.get(i).substring(2));
            assertEquals(where + " " + options.get(i), plain(value), plain(String.valueOf(actual)));
        }
        return options.size();
    }

    private static String plain(String value) {
        boolean isNumber = value.matches("-?[\\d.]+(E-?\\d+)?");
        return isNumber ? new BigDecimal(value).stripTrailingZeros().toPlainString() : value;
    }

    /** Rows such as {@code | 240 x 180 | 98 MB | 0.28 GB |}: the most memory of both presets. */
    @Test
    public void everyBoundOfMemoryThatIsNamedIsTheProgramS() throws Exception {
        Pattern row = Pattern.compile("\\| (\\d+) x (\\d+) \\| ([\\d.]+) MB \\| ([\\d.]+) GB \\|");
        int held = 0;
        for (Map.Entry<Path, String> page : pages().entrySet()) {
            Matcher matcher = row.matcher(page.getValue());
            while (matcher.find()) {
                SensorSize sensor = new SensorSize(Integer.parseInt(matcher.group(1)),
                    Integer.parseInt(matcher.group(2)));
                assertEquals(matcher.group(), matcher.group(3),
                    shown(Sofas.mostBytes(sensor, SofasParameters.defaults()) / 1e6, matcher.group(3)));
                assertEquals(matcher.group(), matcher.group(4),
                    shown(Sofas.mostBytes(sensor, SofasParameters.paper()) / 1e9, matcher.group(4)));
                held++;
            }
        }
        assertTrue("rows", held > 0);
    }

    /** With as many decimals as the page has. */
    private static String shown(double value, String like) {
        int point = like.indexOf('.');
        return String.format(Locale.ROOT, "%." + (point < 0 ? 0 : like.length() - point - 1) + "f", value);
    }

    /** What the first command is said to print, {@code ...} standing for anything. */
    @Test
    public void theFirstCommandPrintsWhatIsSaid() throws Exception {
        Matcher said = Pattern.compile("`(hexagon: \\d+ events, [^`]*)`")
            .matcher(Files.readString(Path.of("README.md")));
        assertTrue("the line", said.find());
        Executed run = Executed.command("run", "recordings/hexagon.aedat", "--out", folder.getRoot().getPath());
        Matcher line = Pattern.compile("\\Q" + said.group(1).replace("...", "\\E.*\\Q") + "\\E").matcher(run.err);
        assertTrue(said.group(1) + " but " + run.err, line.find());
    }

    @Test
    public void everySettingOfTheScriptsIsNamed() throws Exception {
        String said = String.join("\n", pages().values()) + Files.readString(Path.of("CONTRIBUTING.md"));
        for (Path script : List.of(Path.of("sofas"), Path.of("gradlew"), Path.of("src/main/dist/bin/sofas"))) {
            for (String setting : all(Pattern.compile("\\bSOFAS_[A-Z_]+"), Files.readString(script))) {
                assertTrue(script + " takes " + setting, said.contains(setting));
            }
        }
    }
}
