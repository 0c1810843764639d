package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import org.junit.Test;

public class EvaluationReportTest {
    /** Ten events of object 1 at (50, 0), estimated 10 % too fast, and one of noise without flow. */
    private static EvaluationReport report() {
        int n = 11;
        long[] timeUs = new long[n];
        float[] trueVx = new float[n];
        int[] object = new int[n];
        float[] vx = new float[n];
        for (int i = 0; i < n - 1; i++) {
            timeUs[i + 1] = 1000L * (i + 1);
            trueVx[i] = 50;
            object[i] = 1;
            vx[i] = 55;
        }
        Evaluation evaluation = Evaluation.of(new GroundTruth(timeUs, trueVx, new float[n], object),
                FlowEstimate.of(vx, new float[n], Arrays.copyOf(object, n)),
                new EvaluationOptions(0, 50_000, 20_000, 2));
        return new EvaluationReport("0.1", "day/edge.aedat", "day/edge.truth.csv", "sofas", "default",
                Map.of("lifetime-px", 6.0), new EvaluationRun(evaluation, null, 0.5, evaluation.events()));
    }

    private static String csv() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        report().writeCsv(bytes);
        return bytes.toString(StandardCharsets.US_ASCII);
    }

    @Test
    public void csvHasALineForEachFigure() throws IOException {
        String csv = csv();
        assertTrue(csv.startsWith("section,of,figure,value\nflow,all,events,10\n"));
        assertTrue(csv.contains("\nflow,all,share_with_flow,1.000000\n"));
        assertTrue(csv.contains("\nflow,1,magnitude_error_percent_mean,10.000000\n"));
        assertTrue(csv.contains("\nnoise,all,share_with_flow,0.000000\n"));
        assertTrue(csv.contains("\nsegmentation,1,iou_mean,1.000000\n"));
        assertTrue(csv.contains("\nconvergence,0,events,10\n"));
        assertEquals("every line has four fields", csv.lines().count(),
                csv.lines().filter(line -> line.chars().filter(c -> c == ',').count() == 3).count());
    }

    @Test
    public void aFigureOfNothingIsEmptyInCsvAndADashInText() throws IOException {
        assertTrue(csv().contains("\nconvergence,20000,share_with_flow,\n"));
        EvaluationReport none = new EvaluationReport("0.1", "a", "b", "sofas", "default", Map.of(), new EvaluationRun(
                Evaluation.of(new GroundTruth(new long[0], new float[0], new float[0], new int[0]),
                        FlowEstimate.of(new float[0], new float[0], new int[0]), EvaluationOptions.defaults()),
                null, 0, 0));
        assertTrue(none.text().contains("\n  magnitude error percent mean                           -\n"));
    }

    @Test
    public void textNamesRecordingMethodAndEveryFigure() {
        String text = report().text();
        assertTrue(text.startsWith("day/edge.aedat: 11 events, 11 counted (without the first 0.0 % of the time)\n"
                + "sofas: 0.500 s, 22 events/s\n"
                + "\nflow, by object                                        all           1\n"
                + "  events                                                10          10\n"));
        assertTrue(text.contains("\n  magnitude error percent median                    10.000      10.000\n"));
        assertTrue(text.contains("\nsegmentation, by object, in windows of 50 ms           all           1\n"));
        String firstBin = "           0          10       1.000      10.000       0.000       5.000      10.000\n";
        assertTrue(text.endsWith("px/s     error %\n" + firstBin));
    }

    @Test
    public void jsonHasNullForAFigureOfNothingAndNoExponents() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        report().writeJson(bytes);
        String json = bytes.toString(StandardCharsets.UTF_8);
        assertTrue(json, json.startsWith("{\n  \"version\" : \"0.1\",\n  \"recording\" : \"day/edge.aedat\",\n"));
        assertTrue(json, json.contains("\n    \"lifetime-px\" : 6.0\n"));
        assertTrue(json, json.contains("\n    \"1\" : {\n      \"events\" : 10,\n"));
        assertTrue(json, json.contains("\n      \"magnitude_error_percent_mean\" : 10.000000,\n"));
        assertTrue(json, json.contains("\"from_ms\" : 20.000000,\n      \"until_ms\" : 40.000000,\n"
                + "      \"events\" : 0,\n      \"share_with_flow\" : null,\n"));
    }
}
