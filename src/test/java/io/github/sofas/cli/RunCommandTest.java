package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class RunCommandTest {
    private static final Path RECORDINGS = Path.of("recordings");
    private static final Path HEXAGON = RECORDINGS.resolve("hexagon.aedat");
    private static final int HEXAGON_EVENTS = 26_101;
    private static final int RECORD_BYTES = 8;
    private static final int EDGE_EVENTS = 40;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path root;
    private Path out;

    @Before
    public void names() {
        root = folder.getRoot().toPath();
        out = root.resolve("results");
    }

    private Executed run(Object... more) {
        return runTo(out, more);
    }

    private static Executed runTo(Path where, Object... more) {
        List<String> arguments = new ArrayList<>(List.of("run", "--out", where.toString()));
        Arrays.stream(more).map(Object::toString).forEach(arguments::add);
        return Executed.command(arguments.toArray(new String[0]));
    }

    /** Forty events a millisecond apart along a row of a DVS128: the smallest recording that has everything. */
    private static Path writeEdge(Path file) throws IOException {
        Files.createDirectories(file.getParent());
        EventBatch batch = new EventBatch(EDGE_EVENTS);
        for (int i = 0; i < EDGE_EVENTS; i++) {
            batch.add(1000L * i, 20 + i, 64, 1);
        }
        try (Aedat2Writer writer = new Aedat2Writer(file, Chip.named("DVS128").orElseThrow())) {
            writer.write(batch);
        }
        return file;
    }

    /** The recording up to the middle of the record of an event. */
    private static Path cut(Path from, int allEvents, int events, int more, Path to) throws IOException {
        byte[] bytes = Files.readAllBytes(from);
        int header = bytes.length - allEvents * RECORD_BYTES;
        return Files.write(to, Arrays.copyOf(bytes, header + events * RECORD_BYTES + more));
    }

    private static Set<String> filesIn(Path where) {
        String[] names = where.toFile().list();
        return names == null ? Set.of() : new TreeSet<>(List.of(names));
    }

    private static Set<String> results(String... names) {
        Set<String> files = new TreeSet<>();
        for (String name : names) {
            files.addAll(List.of(name + ".flow.csv", name + ".tracks.csv", name + ".segments.csv",
                name + ".summary.json"));
        }
        return files;
    }

    private void assertUsage(String message, Object... arguments) {
        Executed run = run(arguments);
        assertEquals(message + "\nTry 'sofas run --help'.\n", run.err);
        assertEquals("", run.out);
        assertEquals(2, run.exitCode);
        assertFalse("nothing was run", Files.exists(out));
    }

    private static void assertFinished(String name, int events, String line) {
        String pattern = name + ": " + events + " events, \\d+\\.\\d % with flow, \\d+ events/s, \\d+ segments?, "
            + "\\d+\\.\\d\\d s(; most found no flow: .+)?";
        assertTrue(line, line.matches(pattern));
    }

    private static void assertSameResults(Path expected, Path actual) throws IOException {
        assertEquals(filesIn(expected), filesIn(actual));
        for (String name : filesIn(expected)) {
            if (name.endsWith(".csv")) {
                assertArrayEquals(name, Files.readAllBytes(expected.resolve(name)),
                    Files.readAllBytes(actual.resolve(name)));
            }
        }
    }

    @Test
    public void writesARowForEveryEventInOrder() throws IOException {
        Executed run = run(HEXAGON);
        assertEquals(0, run.exitCode);
        assertEquals("", run.out);
        assertEquals(1, run.errLines().size());
        assertFinished("hexagon", HEXAGON_EVENTS, run.errLines().get(0));
        assertEquals(results("hexagon"), filesIn(out));

        List<String> rows = Files.readAllLines(out.resolve("hexagon.flow.csv"));
        List<String> truth = Files.readAllLines(RECORDINGS.resolve("hexagon.truth.csv"));
        assertEquals("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment", rows.get(0));
        assertEquals(HEXAGON_EVENTS + 1, rows.size());
        for (int i = 1; i < rows.size(); i++) {
            assertEquals(event(truth.get(i)), event(rows.get(i)));
        }
    }

    /** Time, x, y and polarity, in which rows of flow and of truth agree. */
    private static List<String> event(String row) {
        return List.of(row.split(",")).subList(0, 4);
    }

    @Test
    public void namesEverySegmentOfARowAndCountsTheRows() throws IOException {
        assertEquals(0, run(HEXAGON).exitCode);
        Set<String> labelled = new TreeSet<>();
        long withFlow = 0;
        for (String row : Files.readAllLines(out.resolve("hexagon.flow.csv")).subList(1, HEXAGON_EVENTS + 1)) {
            String[] fields = row.split(",");
            assertEquals(row, fields[6].equals("0"), fields[4].isEmpty() && fields[5].isEmpty());
            if (!fields[6].equals("0")) {
                labelled.add(fields[6]);
                withFlow++;
            }
        }
        List<String> segments = Files.readAllLines(out.resolve("hexagon.segments.csv"));
        segments.remove(0);
        Set<String> known = new TreeSet<>();
        segments.forEach(segment -> known.add(segment.substring(0, segment.indexOf(','))));
        assertTrue(labelled + " of " + known, known.containsAll(labelled));

        String summary = Files.readString(out.resolve("hexagon.summary.json"));
        assertHas(summary, "\"file\" : \"" + HEXAGON + "\"");
        assertHas(summary, "\"format\" : \"AEDAT 2.0\"");
        assertHas(summary, "\"chip\" : \"DAVIS240C\"");
        assertHas(summary, "\"width\" : 240,\n    \"height\" : 180,\n    \"events\" : 26101,\n");
        assertHas(summary, "\"dvs_events\" : 26101,");
        assertHas(summary, "\"complete\" : true,\n    \"faults\" : [ ],\n"
            + "    \"notes\" : [ ],\n    \"doubtful_share\" : 0.000000\n");
        assertHas(summary, "\"method\" : \"sofas\",\n  \"preset\" : \"default\",\n");
        assertHas(summary, "\n  \"events\" : 26101,\n  \"events_with_flow\" : " + withFlow + ",\n");
        assertHas(summary, "\"segments\" : {\n    \"all\" : " + segments.size() + ",\n");
    }

    private static void assertHas(String text, String part) {
        assertTrue(part + " in " + text, text.contains(part));
    }

    @Test
    public void printsWhatTheReadmeSays() throws IOException {
        Matcher said = Pattern.compile("It prints\n`(hexagon: .*?, )\\.\\.\\.( .*?)`")
            .matcher(Files.readString(Path.of("README.md")));
        assertTrue("the README's example", said.find());
        Executed run = run(HEXAGON);
        // Between the two is the speed, behind them the time.
        assertTrue(run.err, run.err.startsWith(said.group(1)));
        assertTrue(run.err, run.err.contains("events/s," + said.group(2) + ", "));
    }

    @Test
    public void endsTheSummaryWithALineFeed() throws IOException {
        assertEquals(0, run(writeEdge(root.resolve("edge.aedat"))).exitCode);
        String summary = Files.readString(out.resolve("edge.summary.json"));
        assertTrue(summary, summary.endsWith("\n}\n"));
    }

    @Test
    public void writesTheSameBytesOnEveryRun() throws IOException {
        Path again = root.resolve("again");
        assertEquals(0, run(HEXAGON).exitCode);
        assertEquals(0, runTo(again, HEXAGON).exitCode);
        assertSameResults(out, again);
    }

    @Test
    public void writesTheSameBytesHoweverManyRunAtOnce() throws IOException {
        Path atOnce = root.resolve("at once");
        assertEquals(0, run(RECORDINGS, "--jobs", 1).exitCode);
        Executed run = runTo(atOnce, RECORDINGS, "--jobs", 2);
        assertEquals(run.err, 0, run.exitCode);
        assertEquals(4, run.errLines().size());
        assertEquals(results("hexagon", "short-bar", "small-circle", "two-opposite"), filesIn(out));
        assertSameResults(out, atOnce);
    }

    @Test
    public void writesTheSameBytesHoweverManyThreadsRun() throws IOException {
        // the last word of the copy is cut: every event before it has its row, and the damage is said
        Path cut = root.resolve("cut.aedat");
        byte[] whole = Files.readAllBytes(HEXAGON);
        Files.write(cut, Arrays.copyOf(whole, whole.length - 3));
        Executed alone = run(cut, "--threads", 1);
        assertEquals(1, alone.exitCode);
        for (int threads = 2; threads <= 3; threads++) {
            Path together = root.resolve("threads " + threads);
            Executed run = runTo(together, cut, "--threads", threads);
            assertEquals(1, run.exitCode);
            assertSameResults(out, together);
        }
    }

    @Test
    public void runsThePaperPreset() throws IOException {
        assertEquals(0, run(HEXAGON, "--preset", "paper").exitCode);
        assertEquals(HEXAGON_EVENTS + 1, Files.readAllLines(out.resolve("hexagon.flow.csv")).size());
        String summary = Files.readString(out.resolve("hexagon.summary.json"));
        assertHas(summary, "\"preset\" : \"paper\"");
        assertHas(summary, "\"lifetime-px\" : " + SofasParameters.paper().track().lifetimePx() + ",");
    }

    @Test
    public void printsNothingWhereQuietAndSound() {
        Executed run = run(HEXAGON, "--quiet");
        assertEquals(0, run.exitCode);
        assertEquals("", run.out);
        assertEquals("", run.err);
    }

    @Test
    public void printsWhatIsWrongEvenWhereQuiet() throws IOException {
        Path cut = cut(writeEdge(root.resolve("edge.aedat")), EDGE_EVENTS, 39, 1, root.resolve("cut.aedat"));
        Executed run = run(cut, "--quiet");
        assertEquals(1, run.exitCode);
        assertEquals(2, run.errLines().size());
        assertEquals("1 of 1 recording failed: " + cut, run.errLines().get(1));
    }

    @Test
    public void refusesResultsThatExistUnlessForced() throws IOException {
        Path edge = writeEdge(root.resolve("edge.aedat"));
        Path other = writeEdge(root.resolve("other.aedat"));
        Files.createDirectories(out);
        Path existing = Files.writeString(out.resolve("other.segments.csv"), "mine");
        Executed refused = run(edge, other);
        assertEquals("[" + existing + "] exists already; --force replaces it\nTry 'sofas run --help'.\n", refused.err);
        assertEquals(2, refused.exitCode);
        assertEquals("nothing was run", Set.of("other.segments.csv"), filesIn(out));
        assertEquals("mine", Files.readString(existing));

        assertEquals(0, run(edge, other, "--force").exitCode);
        assertEquals(results("edge", "other"), filesIn(out));
        assertFalse(Files.readString(existing).contains("mine"));
    }

    @Test
    public void refusesTwoRecordingsOfOneNameBeforeAnythingRuns() throws IOException {
        Path first = writeEdge(root.resolve("edge.aedat"));
        Path second = writeEdge(root.resolve("edge.aedat2"));
        assertUsage("[" + second + "] results must have different names but those of " + first
            + " are named \"edge\" too; --name-with-extension keeps both", first, second);

        assertEquals(0, run(first, second, "--name-with-extension").exitCode);
        assertEquals(results("edge.aedat", "edge.aedat2"), filesIn(out));
    }

    @Test
    public void refusesRecordingsThatEvenTheirExtensionsDoNotTellApart() throws IOException {
        Path first = writeEdge(root.resolve("a").resolve("edge.aedat"));
        Path second = writeEdge(root.resolve("b").resolve("edge.aedat"));
        assertUsage("[" + second + "] results must have different names but those of " + first
            + " are named \"edge\" too", first, second);
    }

    @Test
    public void runsARecordingNamedTwiceOnce() throws IOException {
        Path edge = writeEdge(root.resolve("edge.aedat"));
        Files.createDirectories(out);
        Executed run = run(edge, out.resolve("..").resolve("edge.aedat"), root);
        assertEquals(run.err, 0, run.exitCode);
        assertEquals(1, run.errLines().size());
    }

    @Test
    public void takesDirectoriesWithoutWhatLiesInsideOrIsNoRecording() throws IOException {
        Path day = root.resolve("day");
        writeEdge(day.resolve("b.AEDAT"));
        writeEdge(day.resolve("a.aedat"));
        writeEdge(day.resolve(".hidden.aedat"));
        writeEdge(day.resolve("deeper").resolve("c.aedat"));
        Files.writeString(day.resolve("notes.txt"), "sunny");
        Executed run = run(day);
        assertEquals(run.err, 0, run.exitCode);
        assertFinished("a", EDGE_EVENTS, run.errLines().get(0));
        assertEquals(results("a", "b"), filesIn(out));
    }

    @Test
    public void expandsPatternsThatTheShellDidNot() throws IOException {
        writeEdge(root.resolve("day1").resolve("a.aedat"));
        writeEdge(root.resolve("day2").resolve("b.aedat"));
        writeEdge(root.resolve("day2").resolve("c.aedat2"));
        writeEdge(root.resolve("night").resolve("d.aedat"));
        Executed run = run(root.resolve("day*") + "/*.aedat");
        assertEquals(run.err, 0, run.exitCode);
        assertEquals(results("a", "b"), filesIn(out));
    }

    @Test
    public void takesHiddenFilesOnlyByPatternsWithADot() throws IOException {
        writeEdge(root.resolve("day").resolve("a.aedat"));
        writeEdge(root.resolve("day").resolve(".b.aedat"));
        writeEdge(root.resolve("day").resolve(".old").resolve("c.aedat"));
        assertEquals(0, run(root + "/day/**").exitCode);
        assertEquals(results("a"), filesIn(out));
        assertEquals(0, run(root + "/day/.*.aedat").exitCode);
        assertEquals(results("a", ".b"), filesIn(out));
    }

    @Test
    public void refusesPatternsThatCannotBeRead() {
        assertUsage("[" + root + "/{a,b] no such file, and no pattern: Missing '}", root + "/{a,b");
        assertUsage("[" + root + "/[a] no such file, and no pattern: Missing ']", root + "/[a");
    }

    @Test
    public void takesAFileWhoseNameLooksLikeAPattern() throws IOException {
        Path file = writeEdge(root.resolve("take[1].aedat"));
        assertEquals(0, run(file).exitCode);
        assertEquals(results("take[1]"), filesIn(out));
    }

    @Test
    public void refusesArgumentsThatMeanNoRecording() throws IOException {
        Path missing = root.resolve("missing.aedat");
        assertUsage("[" + missing + "] no such file", HEXAGON, missing);
        Path empty = Files.createDirectory(root.resolve("empty"));
        assertUsage("[" + empty + "] no recording in this directory: extensions are aedat, aedat2, aedat3, aedat4, "
            + "dat, raw, es, bin, h5, hdf5, csv, txt", empty);
        assertUsage("[" + root + "/*.aedat] no file matches this pattern", root + "/*.aedat");
        assertUsage("[" + root + "/none/*.aedat] no file matches this pattern", root + "/none/*.aedat");
    }

    @Test
    public void recordingThatNeedsMoreMemoryThanThereIsFailsByItself() throws Exception {
        Files.createDirectory(out);
        Path err = root.resolve("err.txt");
        // the paper preset takes hundreds of megabytes for 1280 x 720 px, and 15 for the DVS128 of the other recording
        Path large = Files.writeString(root.resolve("large.txt"), "0.1 7 7 1\n");
        Process run = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC", "-Xmx64m", "-cp", System.getProperty("java.class.path"), Main.class.getName(), "run",
            "--quiet", "--preset", "paper", "--chip", "1280x720", "--out", out.toString(), large.toString(),
            writeEdge(root.resolve("edge.aedat")).toString()).redirectErrorStream(true).redirectOutput(err.toFile())
            .start();
        assertEquals(1, run.waitFor());
        List<String> lines = Files.readAllLines(err);
        assertTrue(lines.get(0), lines.get(0).matches("\\[large.txt\\] out of memory: Java's heap has 6\\d MB; "
            + "SOFAS_JAVA_OPTS=-Xmx4g would give it 4096"));
        assertEquals("1 of 2 recordings failed: " + large, lines.get(lines.size() - 1));
        assertEquals(results("edge"), filesIn(out));
    }

    @Test
    public void recordingWhoseNameIsNoTextIsRunByItsDirectory() throws Exception {
        if (!"UTF-8".equals(System.getProperty("sun.jnu.encoding")) || !Files.isExecutable(Path.of("/bin/sh"))) {
            throw Skipped.because("names are not UTF-8 here, or there is no /bin/sh to make another");
        }
        Path recording = writeEdge(root.resolve("in/edge.aedat"));
        // an e with an accent in Latin-1
        assertEquals(0, new ProcessBuilder("sh", "-c", "mv edge.aedat \"$(printf 'caf\\351.aedat')\"")
            .directory(recording.getParent().toFile()).start().waitFor());
        assertUsage("[caf\uFFFD.aedat] no such file; one whose name is not in UTF-8 is reached by its directory or a "
            + "quoted pattern", "caf\uFFFD.aedat");
        Executed run = run(recording.getParent());
        assertEquals(run.err, 0, run.exitCode);
        assertEquals(results("caf\uFFFD"), filesIn(out));
    }

    @Test
    public void refusesUnknownOptions() {
        assertUsage("Unknown option: '--lifetimepx'\nPossible solutions: --lifespan-us, --lifetime-px", HEXAGON,
            "--lifetimepx", 6);
    }

    @Test
    public void refusesWrongValuesInTheWordsOfTheCommandLine() {
        assertUsage("--lifetime-px must be between 1 and 100 but was 0", HEXAGON, "--lifetime-px", 0);
        assertUsage("--lifetime-px must be a number but was \"NaN\"", HEXAGON, "--lifetime-px", "NaN");
        assertUsage("--lifetime-px must be a number but was \"five\"", HEXAGON, "--lifetime-px", "five");
        assertUsage("--min-events must be a whole number but was \"20.5\"", HEXAGON, "--min-events", 20.5);
        assertUsage("--rotation must be true or false but was \"maybe\"", HEXAGON, "--rotation", "maybe");
        assertUsage("--max-lifetime-px must be at least lifetime-px 5 but was 2", HEXAGON, "--max-lifetime-px", 2);
        assertUsage("--jobs must be at least 1 but was 0", HEXAGON, "--jobs", 0);
        assertUsage("--threads must be 1 to 3 but was 4", HEXAGON, "--threads", 4);
        assertUsage("--threads must be 1 to 3 but was 0", HEXAGON, "--threads", 0);
        assertUsage("--jobs must be a whole number but was \"two\"", HEXAGON, "--jobs", "two");
        assertUsage("--doubtful-share must be a number but was \"some\"", HEXAGON, "--doubtful-share", "some");
        assertUsage("--format must be csv, parquet or npz but was xls", HEXAGON, "--format", "csv,xls");
    }

    @Test
    public void refusesUnknownNamesAndSaysWhichAreKnown() {
        assertUsage("--preset must be one of paper, default but was \"fast\"", HEXAGON, "--preset", "fast");
        assertUsage("--method must be one of sofas, lucas-kanade, local-planes but was \"fast\"", HEXAGON, "--method",
            "fast");
    }

    @Test
    public void refusesAChipThatIsNoneBeforeAnythingIsRun() {
        assertUsage("--chip must name one of " + Chip.knownNames() + " or a size such as 240x180 but was DVS129",
            HEXAGON, "--chip", "DVS129");
        assertUsage("--chip 0x10: sensor width must be between 1 and 1280 but was 0", HEXAGON, "--chip", "0x10");
    }

    @Test
    public void takesParametersFromAFileAndOptionsOverThem() throws IOException {
        Path config = Files.writeString(root.resolve("my.properties"),
            "# mine\nlifetime-px = 6\n  min-events: 44\nrotation=false\n");
        Path edge = writeEdge(root.resolve("edge.aedat"));
        assertEquals(0, run(edge, "--config", config, "--lifetime-px", 7).exitCode);
        String summary = Files.readString(out.resolve("edge.summary.json"));
        assertHas(summary, "\"lifetime-px\" : 7.0,");
        assertHas(summary, "\"min-events\" : 44,");
        assertHas(summary, "\"rotation\" : false,");
    }

    @Test
    public void tellsWhatBecameOfOldParameters() throws IOException {
        assertUsage("--vote-cell-px was removed: it is always 1.3 px; see CHANGELOG.md", HEXAGON, "--vote-cell-px", 2);
        assertUsage("--slow-share was removed: it had no measurable effect; see CHANGELOG.md",
            HEXAGON, "--slow-share", 0);
        Path config = Files.writeString(root.resolve("old.properties"), "lifetime-px=6\nforesight=0\n");
        assertUsage("[old.properties] line 2: foresight was removed: acceleration=false replaces 0; see "
            + "CHANGELOG.md", HEXAGON, "--config", config);
    }

    @Test
    public void namesTheFileAndLineOfAWrongParameter() throws IOException {
        Path config = root.resolve("my.properties");
        Files.writeString(config, "lifetime-px=6\nlifetme-px=7\n");
        String known = String.join(", ", ParameterOptions.asMap(SofasParameters.defaults()).keySet());
        assertUsage("[my.properties] line 2: unknown parameter \"lifetme-px\"; known are " + known, HEXAGON,
            "--config", config);
        Files.writeString(config, "\nlifetime-px=0\n");
        assertUsage("[my.properties] line 2: lifetime-px must be between 1 and 100 but was 0", HEXAGON, "--config",
            config);
        Files.writeString(config, "min-events=few\n");
        assertUsage("[my.properties] line 1: min-events must be a whole number but was \"few\"", HEXAGON, "--config",
            config);
        Files.write(config, new byte[] {(byte) 0xFF, '=', '3'});
        assertUsage("[my.properties] must be text in UTF-8 but is not", HEXAGON, "--config", config);
        Files.write(config, new byte[(1 << 20) + 1]);
        assertUsage("[my.properties] must have at most 1048576 bytes but has more", HEXAGON, "--config", config);
        Files.delete(config);
        assertUsage("[" + config + "] no such file", HEXAGON, "--config", config);
    }

    @Test
    public void refusesAnEmptyNameInPlaceOfARecording() {
        assertUsage("a recording must be a file, a directory or a pattern but was empty", "");
    }

    @Test
    public void refusesAFileForAFolder() throws IOException {
        Path file = Files.writeString(root.resolve("file"), "");
        Executed run = runTo(file, HEXAGON);
        assertEquals("[" + file + "] cannot be made a directory: " + file + ": is a file and no directory"
            + "\nTry 'sofas run --help'.\n", run.err);
        assertEquals(2, run.exitCode);
    }

    @Test
    public void givesResultsOfEveryEventBeforeTheDamage() throws IOException {
        // 247 bytes of header and 10,000 records are whole; 3 bytes of the next one are left.
        Path cut = cut(HEXAGON, HEXAGON_EVENTS, 10_000, 3, root.resolve("cut.aedat"));
        // what comes later would change the labels of the last
        Executed run = run("--causal", cut);
        assertEquals(1, run.exitCode);
        String message = "[cut.aedat] event 10000 at byte 80247: truncated, a record must have 8 bytes but had 3";
        assertEquals(message, run.errLines().get(0));
        assertFinished("cut", 10_000, run.errLines().get(1));
        assertEquals("1 of 1 recording failed: " + cut, run.errLines().get(2));
        assertEquals(3, run.errLines().size());

        assertEquals(results("cut"), filesIn(out));
        assertHas(Files.readString(out.resolve("cut.summary.json")), "\"complete\" : false,\n    \"faults\" : [\n"
            + "      \"" + message + "\"\n    ],\n");
        assertEquals(0, run("--causal", HEXAGON).exitCode);
        assertEquals(Files.readAllLines(out.resolve("hexagon.flow.csv")).subList(0, 10_001),
            Files.readAllLines(out.resolve("cut.flow.csv")));
    }

    @Test
    public void runsTheOthersWhereOneIsDamaged() throws IOException {
        Path good = writeEdge(root.resolve("edge.aedat"));
        Path damaged = Files.writeString(root.resolve("damaged.aedat4"), "no recording");
        Executed run = run(damaged, good);
        assertEquals(1, run.exitCode);
        assertEquals("1 of 2 recordings failed: " + damaged, run.errLines().get(run.errLines().size() - 1));
        assertTrue(run.err, run.errLines().contains("[damaged.aedat4] header at byte 0: unsupported, a recording must "
            + "begin as a known format does or have the extension .aedat, .dat, .bin, .csv or .txt"));
        assertEquals(results("edge"), filesIn(out));
    }

    @Test
    public void listsTheChipsWhereARecordingNamesNone() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write("#!AER-DAT2.0\r\n".getBytes(StandardCharsets.US_ASCII));
        byte[] edge = Files.readAllBytes(writeEdge(root.resolve("edge.aedat")));
        bytes.write(edge, edge.length - EDGE_EVENTS * RECORD_BYTES, EDGE_EVENTS * RECORD_BYTES);
        Path anonymous = Files.write(root.resolve("anonymous.aedat"), bytes.toByteArray());
        Executed run = run(anonymous);
        assertEquals("[anonymous.aedat] the recording names no chip: --chip must name one of DVS128, Tmpdiff128, "
            + "DAVIS240A, DAVIS240B, DAVIS240C, DVS240, Davis346red, Davis346blue, Davis346B, Davis346cBSI, "
            + "Davis346Zynq, Davis128, Davis640\n1 of 1 recording failed: " + anonymous + "\n", run.err);
        assertEquals(1, run.exitCode);
        assertEquals(Set.of(), filesIn(out));

        assertEquals(0, run(anonymous, root.resolve("edge.aedat"), "--chip", "dvs128").exitCode);
        assertArrayEquals(Files.readAllBytes(out.resolve("edge.flow.csv")),
            Files.readAllBytes(out.resolve("anonymous.flow.csv")));
    }

    @Test
    public void givesResultsOfARecordingWithoutEvents() throws IOException {
        Path none = cut(writeEdge(root.resolve("edge.aedat")), EDGE_EVENTS, 0, 0, root.resolve("none.aedat"));
        Executed run = run(none);
        assertEquals(0, run.exitCode);
        assertFinished("none", 0, run.errLines().get(0));
        assertEquals("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\n",
            Files.readString(out.resolve("none.flow.csv")));
    }

    @Test
    public void directoryInPlaceOfAResultIsRefusedBeforeAnythingIsLabelled() throws IOException {
        Path edge = writeEdge(root.resolve("edge.aedat"));
        Path directory = Files.createDirectories(out.resolve("edge.summary.json"));
        for (String option : List.of("--force", "--resume")) {
            Executed run = run(edge, option);
            assertEquals("[" + directory + "] is a directory and cannot be written\nTry 'sofas run --help'.\n",
                run.err);
            assertEquals(2, run.exitCode);
            assertEquals(Set.of("edge.summary.json"), filesIn(out));
        }
    }

    @Test
    public void reportIsOnePageThatNeedsNoOther() throws IOException {
        Executed executed = run("--report", "-q", HEXAGON);
        assertEquals(executed.err, 0, executed.exitCode);
        String page = Files.readString(out.resolve("hexagon.report.html"));
        assertTrue(page.contains("26,101"));
        assertTrue(page.contains("./sofas run --out "));
        assertTrue(page.contains("<video controls loop muted playsinline poster=\"data:image/png;base64,"));
        assertFalse("everything is inside", page.matches("(?s).*(src|href)=\"(?!data:).*"));
        Executed again = run("--report", "-q", HEXAGON);
        assertEquals(2, again.exitCode);
    }

    @Test
    public void lookAheadLabelsMoreOfTheSameEventsAndSaysSo() throws IOException {
        assertEquals(0, run("--causal", HEXAGON).exitCode);
        Path ahead = root.resolve("ahead");
        assertEquals(0, runTo(ahead, "--look-ahead", 200, HEXAGON).exitCode);
        List<String> causalRows = Files.readAllLines(out.resolve("hexagon.flow.csv"));
        List<String> rows = Files.readAllLines(ahead.resolve("hexagon.flow.csv"));
        assertEquals(eventsOf(causalRows), eventsOf(rows));
        assertTrue(withoutFlow(rows) < withoutFlow(causalRows));
        String summary = Files.readString(ahead.resolve("hexagon.summary.json"));
        assertTrue(summary, summary.contains("\"look-ahead-ms\" : 200"));
        assertTrue(summary, summary.contains("\"causal\" : false"));
        String causalSummary = Files.readString(out.resolve("hexagon.summary.json"));
        assertTrue(causalSummary, causalSummary.contains("\"causal\" : true"));
        assertFalse(causalSummary, causalSummary.contains("look-ahead"));
    }

    @Test
    public void recordingsAreLabelledWithLookAheadByDefault() throws IOException {
        assertEquals(0, run(HEXAGON).exitCode);
        Path ahead = root.resolve("ahead");
        assertEquals(0, runTo(ahead, "--look-ahead", 200, HEXAGON).exitCode);
        assertArrayEquals(Files.readAllBytes(ahead.resolve("hexagon.flow.csv")),
            Files.readAllBytes(out.resolve("hexagon.flow.csv")));
        assertTrue(run("--causal", "--look-ahead", 100, HEXAGON).err
            .contains("--causal cannot be combined with --look-ahead"));
    }

    @Test
    public void whatHasNoLookAheadIsLabelledAsItComes() throws IOException {
        for (String[] method : new String[][] {{"--preset", "paper"}, {"--method", "local-planes"}}) {
            Path where = root.resolve(method[1]);
            assertEquals(0, runTo(where, method[0], method[1], HEXAGON).exitCode);
            assertHas(Files.readString(where.resolve("hexagon.summary.json")), "\"causal\" : true");
        }
    }

    @Test
    public void lookAheadGivesBackEveryEventBeforeTheDamage() throws IOException {
        Path cut = cut(HEXAGON, HEXAGON_EVENTS, 10_000, 3, root.resolve("cut.aedat"));
        for (int threads = 1; threads <= 3; threads++) {
            Path where = root.resolve("threads" + threads);
            assertEquals(1, runTo(where, "--look-ahead", 100, "--threads", threads, cut).exitCode);
            assertEquals(10_001, Files.readAllLines(where.resolve("cut.flow.csv")).size());
        }
    }

    private static List<String> eventsOf(List<String> rows) {
        return rows.stream().map(row -> String.join(",", Arrays.asList(row.split(",")).subList(0, 4))).toList();
    }

    private static long withoutFlow(List<String> rows) {
        return rows.stream().filter(row -> row.endsWith(",0")).count();
    }

    @Test
    public void lookAheadGivesTheSameWithAnyNumberOfThreads() throws IOException {
        byte[] first = null;
        for (int threads = 1; threads <= 3; threads++) {
            Path where = root.resolve("threads" + threads);
            assertEquals(0, runTo(where, "--look-ahead", 100, "--threads", threads, HEXAGON).exitCode);
            byte[] rows = Files.readAllBytes(where.resolve("hexagon.flow.csv"));
            first = first == null ? rows : first;
            assertArrayEquals(first, rows);
        }
    }

    @Test
    public void lookAheadIsForTheDefaultPresetOfSofas() {
        assertTrue(run("--look-ahead", 100, "--preset", "paper", HEXAGON).err
            .contains("--look-ahead needs --preset default but was used with paper"));
        assertTrue(run("--look-ahead", 100, "--method", "local-planes", HEXAGON).err
            .contains("--look-ahead needs --method sofas but was used with local-planes"));
        assertTrue(run("--look-ahead", 3, HEXAGON).err.contains("--look-ahead must be 4 to 10000 but was 3"));
        assertFalse(Files.exists(out));
    }
}
