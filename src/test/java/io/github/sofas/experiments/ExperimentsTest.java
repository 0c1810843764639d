package io.github.sofas.experiments;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.BeforeClass;
import org.junit.ClassRule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** One short run of everything, without the recordings of real cameras except for one that is damaged. */
public class ExperimentsTest {
    private static final Path REAL = Path.of("..", "shared", "recordings");

    @ClassRule
    public static final TemporaryFolder FOLDER = new TemporaryFolder();

    private static final ConcurrentLinkedQueue<String> PROGRESS = new ConcurrentLinkedQueue<>();
    private static Experiments experiments;

    @BeforeClass
    public static void runsAll() throws Exception {
        Files.writeString(FOLDER.getRoot().toPath().resolve("cars.aedat"), "no recording");
        experiments = Experiments.run(FOLDER.getRoot().toPath(), 6, 2, PROGRESS::add, 700_000);
    }

    private static String written(ExperimentFiles file) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        file.write(experiments, "1.2.3", bytes);
        return bytes.toString(StandardCharsets.UTF_8);
    }

    @Test
    public void everyMethodLabelsEverySetting() {
        for (Setting setting : Setting.ALL) {
            for (ComparedMethod method : ComparedMethod.values()) {
                Trial trial = experiments.trial(setting, method);
                assertEquals(setting, trial.setting());
                assertTrue(setting.id() + " " + method, trial.evaluation().flow().events() > 100);
                // a recording that cannot be read is a part without a line
                int parts = PROGRESS.size() + experiments.failures().size();
                String part = " of " + parts + ": " + setting.title() + ": " + method.title();
                assertEquals(part, 1, PROGRESS.stream().filter(line -> line.endsWith(part)).count());
            }
        }
    }

    @Test
    public void defaultPresetIsRightOnAHexagonAndLucasKanadeIsNot() {
        Map<String, List<Goal.Check>> checks = experiments.checksByScene();
        assertTrue(checks.get(Setting.HEXAGON.title()).stream()
            .filter(check -> check.figure().equals("magnitude error, mean")).allMatch(Goal.Check::met));
        assertTrue(experiments.trial(Setting.HEXAGON, ComparedMethod.LUCAS_KANADE).evaluation().flow()
            .relativeEndpointErrorPercent().mean() > 30);
    }

    @Test
    public void picturedSettingsShowFlowSegmentsAndContoursAtFourMoments() {
        for (Setting setting : Setting.ALL) {
            for (ComparedMethod method : ComparedMethod.values()) {
                Strip strip = experiments.trial(setting, method).strip();
                if (Setting.PICTURED.contains(setting)) {
                    assertEquals(4, strip.moments().size());
                    strip.moments().forEach(moment ->
                        assertEquals(Set.copyOf(Strip.PANELS), moment.pictures().keySet()));
                } else {
                    assertNull(strip);
                }
            }
        }
        // 58, 70 and 49 px/s: nine tenths of the events are not faster than 100, but faster than 50
        assertEquals(100, experiments.trial(Setting.THREE_CROSSING, ComparedMethod.SOFAS_DEFAULT).strip()
            .fullPxPerS(), 0);
    }

    @Test
    public void recordingsThatAreMissingOrDamagedAreNamed() throws IOException {
        assertEquals(List.of("boxes-translation.aedat", "stripes.aedat", "pendulum-ball.aedat",
            "synthetic-square.aedat"), experiments.missing());
        assertEquals(1, experiments.failures().size());
        assertTrue(experiments.failures().get(0), experiments.failures().get(0).startsWith("[cars.aedat] "));
        String page = written(ExperimentFiles.REPORT);
        assertTrue(page.contains("Not found, and left out: boxes-translation.aedat, stripes.aedat"));
        assertTrue(page.contains("[cars.aedat] "));
    }

    /** Two panels of 480 x 360 px side by side, two rows of them, each with its title. */
    @Test
    public void methodIsPictured() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ExperimentFiles.METHOD.write(experiments, "1.2.3", bytes);
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()));
        assertEquals(3 * 16 + 2 * 480, picture.getWidth());
        assertEquals(16 + 2 * (44 + 360 + 16), picture.getHeight());
    }

    @Test
    public void pageNeedsNoOtherFile() throws IOException {
        String page = written(ExperimentFiles.REPORT);
        assertTrue(page.startsWith("<!DOCTYPE html>\n<html"));
        Matcher references = Pattern.compile("(?:src|srcset|href)=\"([^\"]{0,40})").matcher(page);
        while (references.find()) {
            String to = references.group(1);
            assertTrue(to, to.startsWith("data:image/png;base64,") || to.startsWith("#"));
        }
        assertFalse(page.contains("url("));
        assertFalse(page.contains("<script"));
        assertTrue(page.contains("sofas 1.2.3"));
    }

    @Test
    public void everyLinkOfTheContentsHasItsChapter() throws IOException {
        String page = written(ExperimentFiles.REPORT);
        Matcher links = Pattern.compile("href=\"#([^\"]+)\"").matcher(page);
        int count = 0;
        while (links.find()) {
            assertTrue(links.group(1), page.contains("id=\"" + links.group(1) + "\""));
            count++;
        }
        assertEquals(13, count);
    }

    @Test
    public void everyNumberIsInCsv() throws IOException {
        String figures = written(ExperimentFiles.FIGURES);
        assertTrue(figures.startsWith("setting,method,section,of,figure,value\n"));
        assertTrue(figures.contains("\nhexagon-289,local-planes,flow,all,events,"));
        assertTrue(written(ExperimentFiles.GOALS)
            .contains("\n\"Hexagon, 58 px/s\",\"magnitude error, mean\",≤ 0.50 %,"));
        String histograms = written(ExperimentFiles.HISTOGRAMS);
        assertTrue(histograms.startsWith("setting,method,error,from,until,events\n"
            + "rectangles,sofas-default,magnitude_percent,,-101.000,"));
        // 16 settings, 4 methods, 101 and 91 bins with two more each, and the header
        assertEquals(16 * 4 * (103 + 93) + 1, histograms.lines().count());
        assertTrue(written(ExperimentFiles.CURVES).contains("\npendulum-sofas-paper,true,0.010,"));
        assertEquals(400 * 400 + 20 * 20 + 1, written(ExperimentFiles.METRIC_MAPS).lines().count());
    }

    @Test
    public void theWorstRandomScenesArePictured() throws IOException {
        RandomScenes scenes = experiments.randomScenes();
        assertEquals(6, scenes.random().size());
        assertEquals(5, scenes.worst().size());
        double worst = scenes.random().stream().mapToDouble(SceneFigures.Column.IOU::of).min().orElseThrow();
        assertEquals(worst, SceneFigures.Column.IOU.of(scenes.worst().get(0).figures()), 0);
        assertEquals(4, scenes.worst().get(0).strip().moments().size());
        String page = written(ExperimentFiles.REPORT);
        assertTrue(page.contains("<h3>Among the worst: " + scenes.worst().get(0).figures().name() + "</h3>"));
        String csv = written(ExperimentFiles.RANDOM_SCENES);
        assertTrue(csv, csv.startsWith("scene,objects,events,\"IoU\",\"parts\",\"rEE,%\",\"flow,%\","));
        assertEquals("header, random and textured scenes", 1 + 6 + 19, csv.lines().count());
        assertTrue(csv, csv.contains("\nflicker,0,"));
    }

    @Test
    public void gyroTellsTheVelocityOfTheBoxes() throws Exception {
        if (!Files.isDirectory(REAL)) {
            throw Skipped.because("needs " + REAL + ", which is not part of the project");
        }
        RealExperiment boxes = RealExperiments.BOXES.on(REAL.resolve(RealExperiments.BOXES.fileName()));
        assertEquals(List.of("gyro", "", "27.7", "25.1", "28.8", "28.0", ""), boxes.rows().get(0));
        assertEquals(5, boxes.checks().size());
    }
}
