package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.EvaluationOptions;
import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.evaluate.FlowFigures;
import io.github.sofas.evaluate.TruthCsvReader;
import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.beans.Introspector;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.Test;

/** What the page of the plugin and its help say. */
public class ReadmeFiguresTest {
    private static final Path RECORDINGS = Path.of("../../recordings");

    private static FlowFigures hexagon() throws Exception {
        try (RecordingReader reader = Recordings.open(RECORDINGS.resolve("hexagon.aedat"), RecordingOptions.defaults());
             TruthCsvReader truth = TruthCsvReader.open(RECORDINGS.resolve("hexagon.truth.csv"))) {
            Sofas sofas = new Sofas(reader.sensor(), SofasParameters.defaults());
            EventBatch batch = new EventBatch(4096);
            FlowOutput output = new FlowOutput(4096);
            FlowEstimate estimate = new FlowEstimate();
            while (reader.next(batch)) {
                truth.read(batch);
                sofas.process(batch, output);
                estimate.append(output, batch.size());
            }
            truth.end();
            return Evaluation.of(truth.truth(), estimate, EvaluationOptions.defaults()).flow();
        }
    }

    @Test
    public void figuresOfTheFilterAreThoseOfTheEngine() throws Exception {
        Matcher row = Pattern.compile("\\| SofasFlow \\| ([\\d.]+) % \\| (-?[\\d.]+) ± ([\\d.]+) % "
            + "\\| (-?[\\d.]+) ± ([\\d.]+)° \\| ([\\d.]+) % \\|").matcher(Files.readString(Path.of("README.md")));
        assertTrue("a row of SofasFlow", row.find());
        FlowFigures figures = hexagon();
        double[] measured = {100 * figures.shareWithFlow(), figures.magnitudeErrorPercent().mean(),
            figures.magnitudeErrorPercent().sd(), figures.directionErrorDeg().mean(),
            figures.directionErrorDeg().sd(), figures.relativeEndpointErrorPercent().mean()};
        for (int i = 0; i < measured.length; i++) {
            assertEquals(row.group(i + 1), measured[i], Double.parseDouble(row.group(i + 1)), 0.25);
        }
    }

    /** Properties, and buttons as the panel names them. */
    private static Set<String> controls() throws Exception {
        Set<String> controls = Arrays.stream(Introspector.getBeanInfo(SofasFlow.class).getPropertyDescriptors())
            .map(property -> property.getName()).collect(Collectors.toCollection(TreeSet::new));
        Arrays.stream(SofasFlow.class.getMethods()).map(method -> method.getName())
            .filter(name -> name.startsWith("do")).forEach(name -> controls.add(name.replaceFirst(
                "^do(ToggleOn|ToggleOff)?", "")));
        return controls;
    }

    @Test
    public void everyControlOfTheTablesIsThere() throws Exception {
        Matcher name = Pattern.compile("^\\| `(\\w+)` \\|", Pattern.MULTILINE)
            .matcher(Files.readString(Path.of("README.md")));
        int rows = 0;
        while (name.find()) {
            assertTrue(name.group(1), controls().contains(name.group(1)));
            rows++;
        }
        assertTrue("rows " + rows, rows >= 7);
    }

    @Test
    public void everyControlThatTheHelpNamesIsThere() throws Exception {
        Set<String> controls = controls();
        // jAER's own
        controls.addAll(Set.of("Simple", "displayRawInput"));
        Matcher name = Pattern.compile("<b>(\\w+)</b>").matcher(SofasHelp.TEXT);
        while (name.find()) {
            assertTrue(name.group(1), controls.contains(name.group(1)));
        }
    }

    @Test
    public void pageSaysHowTheJarIsCalled() throws IOException {
        assertTrue(Files.readString(Path.of("README.md"))
            .contains("java -jar sofas-jAER.jar [JAVA_OPTION]... JAER_FOLDER [RECORDING]"));
    }
}
