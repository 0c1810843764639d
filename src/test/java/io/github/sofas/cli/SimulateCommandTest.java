package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.recording.Chip;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.Surface;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class SimulateCommandTest {
    private static final Path RECORDINGS = Path.of("recordings");
    /** A row of the table in the folder's README: the file, its seconds, its events and the command that made it. */
    private static final Pattern MADE_BY = Pattern.compile(
        "\\| `(\\S+)` \\| ([\\d.]+) \\| ([\\d,]+) \\| `\\./sofas (simulate .*) --out recordings` \\|");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path out;

    @Before
    public void names() {
        out = folder.getRoot().toPath().resolve("films");
    }

    private Executed simulate(String... more) {
        List<String> arguments = new ArrayList<>(List.of("simulate", "--out", out.toString()));
        arguments.addAll(List.of(more));
        return Executed.command(arguments.toArray(new String[0]));
    }

    private void assertUsage(String message, String... arguments) {
        Executed simulate = simulate(arguments);
        assertEquals(message + "\nTry 'sofas simulate --help'.\n", simulate.err);
        assertEquals(2, simulate.exitCode);
        assertEquals("", simulate.out);
        assertFalse("nothing was written", Files.exists(out));
    }

    @Test
    public void makesTheRecordingsOfTheFolderAgainByTheCommandsOfItsReadme() throws IOException {
        int made = 0;
        for (String line : Files.readAllLines(RECORDINGS.resolve("README.md"))) {
            Matcher row = MADE_BY.matcher(line);
            if (row.matches()) {
                String name = row.group(1).replace(".aedat", "");
                Executed simulate = simulate(Arrays.stream(row.group(4).split(" ")).skip(1).toArray(String[]::new));
                assertEquals(simulate.err, 0, simulate.exitCode);
                assertEquals(String.format("%s: %s events in %.3f s on DAVIS240C%n", name, row.group(3),
                    Double.parseDouble(row.group(2))), simulate.err);
                assertSameFile(name + ".aedat");
                assertSameFile(name + ".truth.csv");
                made++;
            }
        }
        assertEquals(4, made);
    }

    private void assertSameFile(String name) throws IOException {
        assertArrayEquals(name, Files.readAllBytes(RECORDINGS.resolve(name)), Files.readAllBytes(out.resolve(name)));
    }

    @Test
    public void listsEverySceneWithWhatIsSeen() {
        Executed simulate = Executed.command("simulate", "--list");
        assertEquals(0, simulate.exitCode);
        assertEquals("", simulate.err);
        List<String> lines = simulate.out.lines().toList();
        assertEquals("rectangles       four rectangles, together 120 px wide, moving as one at 58 px/s", lines.get(0));
        assertEquals(Arrays.stream(Scene.values()).map(Scene::sceneName).toList(),
            lines.stream().map(line -> line.substring(0, line.indexOf(' '))).toList());
    }

    @Test
    public void refusesUnknownScenesAndListsTheKnown() {
        assertUsage("unknown scene \"heptagon\"; known are rectangles, hexagon, large-circle, small-circle, pendulum, "
            + "short-bar, long-bar, two-opposite, three-crossing, four-bars, passing-behind, side-by-side, "
            + "three-wandering, swinging-ball, wandering-discs, sixteen, textured-pan, textured-roll, textured-zoom, "
            + "textured-hand, textured-turn, textured-slant, poster, coming-near, going-away, textured-movers, "
            + "flicker, random, noise", "heptagon");
    }

    @Test
    public void refusesUnknownSurfacesAndListsTheKnown() {
        assertUsage("--surface must be one of leaves, smooth, fractal but was \"velvet\"", "textured-pan", "--surface",
            "velvet");
    }

    @Test
    public void wallsCanBeMadeOfSomethingElse() throws IOException {
        Set<String> films = new HashSet<>();
        for (Surface surface : Surface.values()) {
            Executed simulate = simulate("textured-pan", "--duration", "0.02", "--force", "--surface",
                surface.surfaceName());
            assertEquals(simulate.err, 0, simulate.exitCode);
            films.add(Files.readString(out.resolve("textured-pan.truth.csv")));
        }
        assertEquals(Surface.values().length, films.size());
    }

    @Test
    public void valuesThatNoSceneHasAreRefused() {
        assertUsage("--texture must be at most 20.0 but was 1000.0", "hexagon", "--texture", "1000");
        assertUsage("--contrast must be at most 20.0 but was 1000.0", "hexagon", "--contrast", "1000");
        assertUsage("--blur must be at most 100.0 but was 1.0E9", "hexagon", "--blur", "1e9");
        assertUsage("--duration must be 0 or at least 0.001 s but was 1.0E-9", "hexagon", "--duration", "1e-9");
    }

    @Test
    public void needsASceneAndAFolder() {
        Executed noScene = simulate();
        assertTrue(noScene.err, noScene.err.startsWith("Missing required parameter: 'SCENE'; known are rectangles, "));
        assertEquals(2, noScene.exitCode);
        Executed noFolder = Executed.command("simulate", "hexagon");
        assertEquals("Missing required option: '--out=DIR'\nTry 'sofas simulate --help'.\n", noFolder.err);
        assertEquals(2, noFolder.exitCode);
    }

    @Test
    public void filmsWithEveryChip() {
        for (Chip chip : Chip.known()) {
            Executed simulate = simulate("small-circle", "--duration", "0.01", "--chip", chip.name(), "--force");
            assertEquals(simulate.err, 0, simulate.exitCode);
            assertTrue(simulate.err, simulate.err.matches("small-circle: [\\d,]+ events in 0\\.010 s on " + chip.name()
                + "\n"));
            Executed info = Executed.command("info", out.resolve("small-circle.aedat").toString());
            assertTrue(info.out, info.out.contains("  chip:                " + chip.name() + "\n"
                + "  sensor:              " + chip.sensor() + " px\n"));
            assertTrue(info.out, info.out.endsWith("  faults:              none\n"));
        }
    }

    @Test
    public void refusesUnknownChipsAndListsTheKnown() {
        assertUsage("--chip must be one of " + Chip.known().stream().map(Chip::name).collect(Collectors.joining(", "))
            + " but was \"DVS1\"", "hexagon", "--chip", "DVS1");
    }

    @Test
    public void refusesWordsForNumbers() {
        assertUsage("--duration must be a number but was \"long\"", "hexagon", "--duration", "long");
    }

    @Test
    public void refusesWrongValuesInTheWordsOfTheCommandLine() {
        for (String option : List.of("--duration", "--speed", "--texture", "--field-of-view", "--mismatch", "--jitter",
            "--refractory", "--noise", "--hot-pixel-rate")) {
            assertUsage(option + " must not be negative but was -1.0", "hexagon", option, "-1");
        }
        for (String option : List.of("--scale", "--contrast", "--blur", "--threshold-on", "--threshold-off")) {
            assertUsage(option + " must be positive but was 0.0", "hexagon", option, "0");
        }
        assertUsage("--hot-pixels must not be negative but was -1.0", "hexagon", "--hot-pixels", "-1");
        assertUsage("--direction must be finite but was NaN", "hexagon", "--direction", "NaN");
        assertUsage("--turns must be finite and not 0 but was 0.0", "hexagon", "--turns", "0");
        assertUsage("--duration must not be negative but was NaN", "hexagon", "--duration", "NaN");
    }

    @Test
    public void refusesFilesThatExistUnlessForced() throws IOException {
        Files.createDirectories(out);
        Path existing = Files.writeString(out.resolve("noise.truth.csv"), "mine");
        Executed refused = simulate("noise", "--duration", "0.01");
        assertEquals("[" + existing + "] exists already; --force replaces it\nTry 'sofas simulate --help'.\n",
            refused.err);
        assertEquals(2, refused.exitCode);
        assertFalse(Files.exists(out.resolve("noise.aedat")));

        assertEquals(0, simulate("noise", "--duration", "0.01", "--force").exitCode);
        assertTrue(Files.readString(existing).startsWith("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object\n"));
    }

    @Test
    public void printsNothingWhereQuiet() {
        Executed simulate = simulate("noise", "--duration", "0.01", "--quiet");
        assertEquals(0, simulate.exitCode);
        assertEquals("", simulate.out + simulate.err);
    }

    @Test
    public void namesARandomSceneByItsSeed() throws IOException {
        assertEquals(0, simulate("random:7", "--duration", "0.1").exitCode);
        assertEquals(0, simulate("random", "--seed", "7", "--duration", "0.1").exitCode);
        assertArrayEquals(Files.readAllBytes(out.resolve("random.truth.csv")),
            Files.readAllBytes(out.resolve("random-7.truth.csv")));
    }

    @Test
    public void refusesSeedsThatAreNone() {
        assertUsage("the seed of a random scene must be a whole number but was \"x\"", "random:x");
        assertUsage("only random may have a seed in its name but it was \"hexagon:7\"", "hexagon:7");
        assertUsage("--seed cannot be combined with a seed in the scene's name but it was \"random:7\"", "random:7",
            "--seed", "3");
    }

    @Test
    public void filmsOtherNoiseWithAnotherSeed() throws IOException {
        assertEquals(0, simulate("noise", "--duration", "0.5", "--seed", "2").exitCode);
        byte[] first = Files.readAllBytes(out.resolve("noise.aedat"));
        assertEquals(0, simulate("noise", "--duration", "0.5", "--seed", "3", "--force").exitCode);
        assertFalse(Arrays.equals(first, Files.readAllBytes(out.resolve("noise.aedat"))));
    }
}
