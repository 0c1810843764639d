package io.github.sofas.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipInputStream;
import javax.imageio.ImageIO;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class RenderCommandTest {
    private static final String RECORDING = "recordings/short-bar.aedat";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Executed render(String... more) {
        String[] args = Stream.concat(Stream.of("render", RECORDING, "--out", folder.getRoot().toString(), "-q"),
            Stream.of(more)).toArray(String[]::new);
        return Executed.command(args);
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder.getRoot().toPath())) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private void refuses(String message, String... more) throws IOException {
        Executed executed = render(more);
        assertEquals(message, executed.err.lines().findFirst().orElse(""));
        assertEquals(2, executed.exitCode);
        assertEquals(List.of(), files());
    }

    @Test
    public void writesAFilmAndNothingElse() throws IOException {
        Executed executed = render("--scale", "1", "--to", "0.1");
        assertEquals("", executed.err);
        assertEquals(0, executed.exitCode);
        assertEquals(List.of("short-bar.mp4"), files());
    }

    @Test
    public void resultsOfARunGiveTheSameFilm() throws IOException {
        String dir = folder.getRoot().toString();
        // no arrows: their ends would show the third decimal of velocities, to which the rows are rounded
        String[] same = {"--scale", "1", "--format", "png", "--to", "0.2", "--panels", "events,flow"};
        assertEquals(0, render(same).exitCode);
        List<int[]> labelled = pictures(Files.readAllBytes(Path.of(dir, "short-bar.png.zip")));
        assertEquals(0, Executed.command("run", RECORDING, "--out", dir, "-q").exitCode);
        assertEquals(0, render(Stream.concat(Stream.of(same), Stream.of("--force", "--results", dir))
            .toArray(String[]::new)).exitCode);
        List<int[]> again = pictures(Files.readAllBytes(Path.of(dir, "short-bar.png.zip")));
        int different = 0;
        for (int k = 0; k < again.size(); k++) {
            for (int i = 0; i < again.get(k).length; i++) {
                different += again.get(k)[i] == labelled.get(k)[i] ? 0 : 1;
            }
        }
        assertTrue(different + " pixels, whose colours lay on the border between two", different <= 5);
    }

    /** A recording of three events, as text, and results in which they are told as in the lines. */
    private Executed renderThreeEvents(String... lines) throws IOException {
        Path recording = folder.getRoot().toPath().resolve("three.txt");
        Files.writeString(recording, "0.001 5 6 1\n0.002 7 8 0\n0.003 9 10 1\n");
        Path results = Files.createDirectories(folder.getRoot().toPath().resolve("results"));
        Files.writeString(results.resolve("three.flow.csv"),
            "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\n" + String.join("\n", lines) + "\n");
        return Executed.command("render", recording.toString(), "--chip", "32x32", "--results", results.toString(),
            "--out", folder.getRoot().toString(), "-q", "--force");
    }

    @Test
    public void resultsMustBeOfTheRecordingsEvents() throws IOException {
        String[] events = {"1000,5,6,1,,,0", "2000,7,8,-1,20.5,-3,1", "3000,9,10,1,,,0"};
        assertEquals("", renderThreeEvents(events).err);

        Executed other = renderThreeEvents(events[0], "2000,8,8,-1,,,0", events[2]);
        assertEquals("[three.flow.csv] line 3: must be event 1 of three.txt, 2000,7,8,-1, but was 2000,8,8,-1\n",
            other.err);
        assertEquals(1, other.exitCode);
        assertEquals("[three.flow.csv] line 4: must be event 2 of three.txt, 3000,9,10,1, but the file ends\n",
            renderThreeEvents(events[0], events[1]).err);
        assertEquals("[three.flow.csv] line 5: must end with the 3 events of three.txt but goes on with 4000,1,1,1\n",
            renderThreeEvents(events[0], events[1], events[2], "4000,1,1,1,,,0").err);
    }

    private static List<int[]> pictures(byte[] zip) throws IOException {
        List<int[]> pictures = new ArrayList<>();
        try (ZipInputStream in = new ZipInputStream(new ByteArrayInputStream(zip))) {
            while (in.getNextEntry() != null) {
                BufferedImage picture = ImageIO.read(new ByteArrayInputStream(in.readAllBytes()));
                pictures.add(picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0,
                    picture.getWidth()));
            }
        }
        assertEquals("0.2 s at 30 pictures a second", 6, pictures.size());
        return pictures;
    }

    @Test
    public void filmThatExistsIsReplacedOnlyByForce() throws IOException {
        Path film = folder.newFile("short-bar.gif").toPath();
        Executed executed = render("--format", "gif", "--to", "0.05", "--scale", "1");
        assertEquals("[" + film + "] exists already; --force replaces it",
            executed.err.lines().findFirst().orElse(""));
        assertEquals(2, executed.exitCode);
        assertEquals(0, render("--format", "gif", "--to", "0.05", "--scale", "1", "--force").exitCode);
        assertTrue(Files.size(film) > 0);
    }

    @Test
    public void wrongUsageIsRefusedBeforeAnythingIsWritten() throws IOException {
        refuses("--fps must be above 0 and below 1,000,000 but was 0.0", "--fps", "0");
        refuses("--fps must be at most 240 but was 241.0", "--fps", "241");
        refuses("--slow must be above 0 and below 1,000,000 but was -1.0", "--slow", "-1");
        refuses("--every must be above 0 but was 0", "--every", "0");
        refuses("--every and --slow exclude each other: a picture comes by events or by time", "--every", "9", "--slow",
            "2");
        refuses("--max-pictures must be above 0 but was 0", "--max-pictures", "0");
        refuses("--from must not be negative and --to must be later but they were 2.0 and 1.0", "--from", "2", "--to",
            "1");
        for (String exposure : List.of("20", "0ms", "0.5ev", "-1ms", "ms")) {
            refuses("--exposure must be a time above 0 such as 20ms or a count such as 5000ev but was \"" + exposure
                + "\"", "--exposure", exposure);
        }
        refuses("[short-bar.aedat] crop must lie on the sensor of 240x180 but was 230,0,20,20", "--crop",
            "230,0,20,20");
        refuses("--crop must be X,Y,W,H in px but was \"1,2\"", "--crop", "1,2");
        refuses("--scale must be between 1 and 16 but was 17", "--scale", "17");
        refuses("--full-speed must be above 0 and below 1,000,000 but was Infinity", "--full-speed", "Infinity");
        refuses("panels must be one or more, each once, but were [flow, flow]", "--panels", "flow,flow");
        refuses("--panels contours cannot be combined with --results: it needs the track planes", "--panels",
            "contours", "--results", "recordings");
        refuses("--panels contours needs --method sofas but was used with lucas-kanade", "--panels", "contours",
            "--method", "lucas-kanade");
        refuses("--panels contours cannot be combined with --look-ahead: track planes are those of the newest event",
            "--panels", "contours", "--look-ahead", "100");
    }

    @Test
    public void lookAheadShowsTheSameEventsWithOtherLabels() throws IOException {
        Path film = folder.getRoot().toPath().resolve("short-bar.png.zip");
        String[] options = {"--format", "png", "--max-pictures", "5", "--force"};
        assertEquals(0, render(options).exitCode);
        byte[] causal = Files.readAllBytes(film);
        String[] ahead = {"--format", "png", "--max-pictures", "5", "--force", "--look-ahead", "100"};
        assertEquals(0, render(ahead).exitCode);
        byte[] first = Files.readAllBytes(film);
        assertFalse(Arrays.equals(causal, first));
        assertEquals(0, render(ahead).exitCode);
        assertArrayEquals(first, Files.readAllBytes(film));
    }

    @Test
    public void filmEndsEarlyOnlyIfEventsAreLeft() throws IOException {
        String[] whole = {"--format", "png", "--scale", "1", "--every", "1000000", "--max-pictures", "1"};
        assertEquals("", render(whole).err);
        Executed executed = render("--format", "png", "--scale", "1", "--every", "1000", "--max-pictures", "1",
            "--force");
        assertEquals("[short-bar.aedat] the film ends early: it has the 1 pictures of --max-pictures\n", executed.err);
        // the one picture is due at 0.1 s, where --to ends the film as well
        assertEquals("", render("--format", "png", "--scale", "1", "--fps", "10", "--to", "0.1", "--max-pictures", "1",
            "--force").err);
    }

    @Test
    public void pictureTooLargeForPlayersIsRefusedAndLeavesNoFilm() throws IOException {
        Executed executed = render("--scale", "16", "--panels", "events,flow,segments");
        // two panels of 240 x 16 px with 8 px about each, two rows of 180 x 16 px with title and legend
        assertEquals("[short-bar.aedat] a picture must have at most 9437184 pixels but would be 7712x5936: take a "
            + "smaller scale or fewer panels", executed.errLines().get(0));
        assertEquals(2, executed.exitCode);
        assertEquals(List.of(), files());
    }

    @Test
    public void timeWithoutEventsIsAFailureAndLeavesNoFilm() throws IOException {
        Executed executed = render("--from", "1000");
        assertEquals("[short-bar.aedat] there must be an event between --from and --to but there was none",
            executed.err.strip());
        assertEquals(1, executed.exitCode);
        assertEquals(List.of(), files());
    }
}
