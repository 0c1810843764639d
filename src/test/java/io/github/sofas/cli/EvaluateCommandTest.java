package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.evaluate.TruthCsvReader;
import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class EvaluateCommandTest {
    private static final int EVENTS = 40;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final List<String> lines = new ArrayList<>();
    private Path recording;
    private Path truth;

    /** Forty events a millisecond apart along a row of a DVS128, of object 1. */
    @Before
    public void writeRecordingAndTruth() throws IOException {
        recording = folder.getRoot().toPath().resolve("edge.aedat");
        truth = folder.getRoot().toPath().resolve("edge.truth.csv");
        EventBatch batch = new EventBatch(EVENTS);
        lines.add(TruthCsvReader.HEADER);
        for (int i = 0; i < EVENTS; i++) {
            batch.add(1000L * i, 20 + i, 64, 1);
            lines.add(1000 * i + "," + (20 + i) + ",64,1,1000,0,1");
        }
        try (Aedat2Writer writer = new Aedat2Writer(recording, Chip.named("DVS128").orElseThrow())) {
            writer.write(batch);
        }
        Files.write(truth, lines);
    }

    private int evaluate(String... more) {
        List<String> arguments = new ArrayList<>(List.of("evaluate", recording.toString(), "--truth",
            truth.toString()));
        arguments.addAll(List.of(more));
        return Main.execute(new PrintWriter(out), new PrintWriter(err), arguments.toArray(new String[0]));
    }

    private void assertError(int exitCode, String message, String... more) {
        assertEquals(exitCode, evaluate(more));
        assertEquals(message, err.toString().lines().findFirst().orElse(""));
        assertEquals("", out.toString());
    }

    @Test
    public void printsTheFiguresOfSofas() {
        assertEquals(0, evaluate());
        assertTrue(out.toString(), out.toString().startsWith(recording
            + ": 40 events, 34 counted (without the first 15.0 % of the time)\nsofas: "));
        assertEquals("", err.toString());
    }

    private String jsonOfHexagon(String name, String... more) throws IOException {
        Path json = folder.getRoot().toPath().resolve(name);
        List<String> arguments = new ArrayList<>(List.of("evaluate", "recordings/hexagon.aedat", "--truth",
            "recordings/hexagon.truth.csv", "--skip-first-share", "0", "--json", json.toString()));
        arguments.addAll(List.of(more));
        assertEquals(0, Main.execute(new PrintWriter(out), new PrintWriter(err), arguments.toArray(new String[0])));
        return Files.readString(json);
    }

    private static double shareWithFlow(String json) {
        int at = json.indexOf("\"share_with_flow\" : ") + "\"share_with_flow\" : ".length();
        return Double.parseDouble(json.substring(at, json.indexOf(',', at)));
    }

    @Test
    public void lookAheadIsEvaluatedAsItIsAskedFor() throws IOException {
        String causal = jsonOfHexagon("causal.json", "--causal");
        String ahead = jsonOfHexagon("ahead.json", "--look-ahead", "200");
        assertFalse(causal, causal.contains("look-ahead-ms"));
        assertTrue(ahead, ahead.contains("\"look-ahead-ms\" : 200"));
        assertTrue(ahead, shareWithFlow(ahead) > 0.99 && shareWithFlow(causal) < 0.99);
    }

    @Test
    public void leavesOutTheShareThatIsAskedFor() {
        assertEquals(0, evaluate("--skip-first-share", "0.5"));
        // 39 ms: half is 19.5 ms, so that events 20 to 39 count.
        assertTrue(out.toString(), out.toString().contains("40 events, 20 counted (without the first 50.0 %"));
    }

    @Test
    public void writesJsonAndCsv() throws IOException {
        Path json = folder.getRoot().toPath().resolve("figures.json");
        Path csv = folder.getRoot().toPath().resolve("figures.csv");
        assertEquals(0, evaluate("--method", "lucas-kanade", "--derivative", "backward-difference", "--json",
            json.toString(), "--csv", csv.toString()));
        String text = Files.readString(json);
        assertTrue(text, text.contains("\"method\" : \"lucas-kanade\""));
        assertTrue(text, text.contains("\"derivative\" : \"backward-difference\""));
        assertTrue(text, text.contains("\"events_counted\" : 34,"));
        assertTrue(Files.readString(csv).startsWith("section,of,figure,value\nflow,all,events,34\n"));
    }

    @Test
    public void refusesResultsThatExistUnlessForced() throws IOException {
        Path csv = folder.newFile("figures.csv").toPath();
        assertError(2, "[" + csv + "] exists already; --force replaces it", "--csv", csv.toString());
        assertEquals(0, evaluate("--csv", csv.toString(), "--force"));
        assertTrue(Files.size(csv) > 0);
    }

    @Test
    public void namesTheLineWhereTruthAndRecordingDiffer() throws IOException {
        lines.set(5, "4000,25,64,1,1000,0,1");
        Files.write(truth, lines);
        assertError(1, "[edge.truth.csv] line 6: must be event 4 of the recording (t_us 4000, x 24, y 64, polarity 1) "
            + "or one after it but was (t_us 4000, x 25, y 64, polarity 1)");
    }

    @Test
    public void evaluatesADamagedRecordingUpToTheDamage() throws IOException {
        byte[] bytes = Files.readAllBytes(recording);
        Files.write(recording, java.util.Arrays.copyOf(bytes, bytes.length - 3));
        assertEquals(1, evaluate());
        assertTrue(out.toString(), out.toString().contains(": 39 events, "));
        assertTrue(err.toString(), err.toString().startsWith("[edge.aedat] event 39 at byte "));
    }

    @Test
    public void refusesTruthThatIsNotThere() throws IOException {
        Files.delete(truth);
        assertError(2, "[" + truth + "] no such file");
    }

    private int measure(String... more) {
        List<String> arguments = new ArrayList<>(List.of("evaluate", recording.toString()));
        arguments.addAll(List.of(more));
        return Main.execute(new PrintWriter(out), new PrintWriter(err), arguments.toArray(new String[0]));
    }

    @Test
    public void measuresSharpnessWithoutTruth() throws IOException {
        Path json = folder.getRoot().toPath().resolve("sharpness.json");
        Path csv = folder.getRoot().toPath().resolve("sharpness.csv");
        assertEquals(0, measure("--method", "local-planes", "--json", json.toString(), "--csv", csv.toString()));
        String[] text = out.toString().split("\n");
        assertEquals(recording + ": 40 events, 1 windows, 0.0 % with flow", text[0]);
        assertTrue(text[2], text[2].startsWith("sharpness 1.000, best single translation "));
        assertEquals(6, text.length);
        assertTrue(Files.readString(json).contains("\"sharpness\" : {\n    \"all\" : {\n      \"windows\" : 1,"));
        assertTrue(Files.readString(csv).startsWith("section,of,figure,value\nsharpness,all,windows,1\n"
            + "sharpness,all,events,40\n"));
        assertTrue(Files.readString(csv).contains("\nsharpness,0,until_us,39000\n"));
    }

    @Test
    public void measuresADamagedRecordingUpToTheDamage() throws IOException {
        byte[] bytes = Files.readAllBytes(recording);
        Files.write(recording, java.util.Arrays.copyOf(bytes, bytes.length - 3));
        assertEquals(1, measure());
        assertTrue(out.toString(), out.toString().contains(": 39 events, "));
        assertTrue(err.toString(), err.toString().startsWith("[edge.aedat] event 39 at byte "));
    }

    @Test
    public void refusesAShareToSkipWithoutTruth() {
        assertEquals(2, measure("--skip-first-share", "0.1"));
        assertTrue(err.toString(), err.toString().startsWith("--skip-first-share needs --truth"));
    }

    @Test
    public void refusesAShareOfOne() {
        assertError(2, "--skip-first-share must be at least 0 and below 1 but was 1.0", "--skip-first-share", "1");
    }

    @Test
    public void refusesOptionsOfAnotherMethod() {
        assertError(2, "--preset needs --method sofas but was used with local-planes", "--method", "local-planes",
            "--preset", "paper");
    }

    @Test
    public void refusesADerivativeWithoutLucasKanade() {
        assertError(2, "--derivative needs --method lucas-kanade but was used with sofas", "--derivative",
            "central-difference");
    }

    @Test
    public void writesNothingWhereTheTruthIsWrong() throws IOException {
        Path csv = folder.getRoot().toPath().resolve("figures.csv");
        lines.set(9, "nothing");
        Files.write(truth, lines);
        assertEquals(1, evaluate("--csv", csv.toString()));
        assertFalse(Files.exists(csv));
    }

    @Test
    public void takesATruthOfAPartOfTheEvents() throws IOException {
        lines.subList(1, 21).clear();
        Files.write(truth, lines);
        assertEquals(0, evaluate());
        assertTrue(out.toString(), out.toString().startsWith(recording
            + ": 20 of 40 events have a truth, 17 counted "));
    }

    /** Every event 10 % too fast. */
    @Test
    public void evaluatesResultsThatExist() throws IOException {
        List<String> labels = new ArrayList<>(List.of("segment,t_us,x,y,polarity,vy_px_per_s,vx_px_per_s"));
        for (int i = 0; i < EVENTS; i++) {
            labels.add("4," + 1000 * i + "," + (20 + i) + ",64,1,0,1100");
        }
        Path results = Files.write(folder.getRoot().toPath().resolve("mine.csv"), labels);
        assertEquals(0, evaluate("--results", results.toString()));
        assertTrue(out.toString(), out.toString().matches("(?s).*magnitude error percent mean +10.0.*"));
        labels.remove(EVENTS);
        Files.write(results, labels);
        out.getBuffer().setLength(0);
        assertError(1, "[mine.csv] line 41: must be event 39 of the recording (t_us 39000, x 59, y 64, polarity 1) but "
            + "the file ends", "--results", results.toString());
    }

    @Test
    public void refusesAFileInAFolderThatIsNotThereBeforeAnythingIsMeasured() {
        Path nowhere = folder.getRoot().toPath().resolve("nowhere");
        assertError(2, "[" + nowhere.resolve("f.json") + "] cannot be written: there is no directory " + nowhere,
            "--json", nowhere.resolve("f.json").toString());
        err.getBuffer().setLength(0);
        Path file = truth.resolve("f.csv");
        assertError(2, "[" + file + "] cannot be written: there is no directory " + truth, "--csv", file.toString());
    }

    @Test
    public void refusesADirectoryInPlaceOfAFile() {
        assertError(2, "[" + folder.getRoot() + "] is a directory and cannot be written", "--force", "--json",
            folder.getRoot().toString());
    }
}
