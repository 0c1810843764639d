package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.jcodec.api.FrameGrab;
import org.jcodec.api.JCodecException;
import org.jcodec.common.io.NIOUtils;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class RunReportTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private String report(Path recording) throws IOException {
        String name = recording.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        Path out = folder.getRoot().toPath().resolve("out");
        String[] args = {"run", recording.toString(), "--out", out.toString(), "--report", "-q", "--force"};
        assertEquals(0, Executed.command(args).exitCode);
        return Files.readString(out.resolve(name + ".report.html"));
    }

    private static List<String> all(String regex, String text) {
        return Pattern.compile(regex).matcher(text).results().map((MatchResult found) -> found.group(1)).toList();
    }

    @Test
    public void pageNeedsNothingFromElsewhere() throws IOException {
        String page = report(Path.of("recordings/short-bar.aedat"));
        for (String source : all("\\b(?:src|href|poster)=\"([^\"]{0,40})", page)) {
            assertTrue(source, source.startsWith("data:"));
        }
        assertFalse(page.replace("http://www.w3.org/2000/svg", "").contains("http"));
        assertFalse(page.contains("url("));
        assertFalse(page.contains("@import"));
    }

    @Test
    public void pageHasAllItsPartsWithoutAScript() throws IOException {
        String page = report(Path.of("recordings/short-bar.aedat")).replaceFirst("(?s)<script>.*</script>", "");
        assertEquals(List.of("What moves", "Busiest moments", "How sharp it is", "Over time", "Segments",
            "Where it moves", "How to reproduce this"), all("<h2>([^<]*)</h2>", page));
        assertEquals(List.of("Life lines", "Table"), all("<h3>([^<]*)</h3>", page));
        assertEquals("rate, share, speed, direction, life lines", 5, all("(<svg class=\"plot)", page).size());
        assertEquals(1, all("(<svg class=\"polar\")", page).size());
        assertTrue(page.contains("<td>lifetime-px</td><td>5.0</td>"));
    }

    @Test
    public void pageSaysHowMuchSharperTheFlowMakesThePicture() throws IOException {
        String page = report(Path.of("recordings/hexagon.aedat"));
        int percent = Integer.parseInt(all("<p>This flow makes the picture (\\d+) % sharper\\.</p>", page).get(0));
        assertTrue("hexagon of 65 px at 58 px/s: " + percent, percent > 50);
        assertEquals(List.of("before", "after"), all("alt=\"the events (before|after)\"", page));
    }

    @Test
    public void clipHasAPosterAndItsLegendBelow() throws IOException {
        String page = report(Path.of("recordings/short-bar.aedat"));
        assertEquals(1, all("<video[^>]* (poster)=\"data:image/png;base64,", page).size());
        assertTrue(page.indexOf("class=\"legends\"") > page.indexOf("<video"));
        assertEquals(2, all("<img alt=\"(Colours of directions|A colour and a number)", page).size());
    }

    @Test
    public void axesHaveRoundNumbers() throws IOException {
        String page = report(Path.of("recordings/short-bar.aedat"));
        List<String> labels = all("<text[^>]*>(-?[\\d.]+k?(?: s)?)</text>", page);
        assertTrue(labels.size() + " labels", labels.size() > 20);
        for (String label : labels) {
            // segments have numbers too, left of their life lines
            assertTrue(label, label.matches("-?(\\d{1,2}|[1-9]0+|1[0-9]0+|\\d?\\.0*[1-9]|90|180)(k| s|k s)?"));
        }
        assertTrue(labels.toString(), labels.containsAll(List.of("0.2", "0.6 s", "-90", "90", "180")));
    }

    @Test
    public void directionsRunDownwardsAsInTheFiles() throws IOException {
        String page = report(Path.of("recordings/short-bar.aedat"));
        assertTrue(page.contains("Direction: 0 right, 90 down, ±180 left, °"));
    }

    @Test
    public void tableListsTheSegments() throws IOException {
        String page = report(Path.of("recordings/two-opposite.aedat"));
        String table = page.substring(page.indexOf("<h3>Table</h3>"));
        assertEquals(List.of("segment", "from, s", "to, s", "events", "right, px/s", "down, px/s", "became"),
            all("<th>([^<]*)</th>", table));
        assertTrue(table, table.contains("<td>alive</td>"));
        assertFalse("no -0", table.contains("<td>-0</td>"));
    }

    @Test
    public void noteIsNoFault() throws IOException {
        Path out = folder.getRoot().toPath().resolve("out");
        assertEquals(0, Executed.command("run", "recordings/short-bar.aedat", "--out", out.toString(), "--report",
            "-q", "--chip", "DVS128").exitCode);
        String page = Files.readString(out.resolve("short-bar.report.html"));
        assertTrue(page.contains("<p class=\"note\">[short-bar.aedat] the header names DAVIS240C, so --chip DVS128 was "
            + "not used; --force-chip uses it</p>"));
        assertFalse(page.contains("class=\"bad\""));
    }

    /** short-bar.aedat is of 0.749986 s: 22 times 33,333 µs and a rest. */
    @Test
    public void clipHasThirtyPicturesASecond() throws IOException, JCodecException {
        String page = report(Path.of("recordings/short-bar.aedat"));
        Path clip = folder.getRoot().toPath().resolve("clip.mp4");
        Files.write(clip, Base64.getDecoder().decode(all("data:video/mp4;base64,([^\"]*)", page).get(0)));
        FrameGrab grab = FrameGrab.createFrameGrab(NIOUtils.readableChannel(clip.toFile()));
        assertEquals(23, grab.getVideoTrack().getMeta().getTotalFrames());
    }

    @Test
    public void namesCannotBeTakenForMarks() throws IOException {
        Path recording = folder.getRoot().toPath().resolve("a<b>&.aedat");
        Files.copy(Path.of("recordings/short-bar.aedat"), recording);
        String page = report(recording);
        assertTrue(page.contains("<h1>a&lt;b&gt;&amp;.aedat</h1>"));
        assertFalse(page.contains("a<b>"));
    }

    @Test
    public void recordingWithoutEventsHasAReport() throws IOException {
        Path recording = folder.getRoot().toPath().resolve("none.txt");
        Files.writeString(recording, "# nothing\n");
        Path out = folder.getRoot().toPath().resolve("out");
        assertEquals(0, Executed.command("run", recording.toString(), "--out", out.toString(), "--report", "-q",
            "--chip", "240x180").exitCode);
        String page = Files.readString(out.resolve("none.report.html"));
        assertTrue(page.contains("No segment was found."));
        assertFalse(page.contains("<video"));
    }
}
