package io.github.sofas.experiments;

import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.recording.ImuSample;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntPredicate;

/**
 * The recordings with an experiment each: of real cameras, and of a square that a program drew, whose velocity is
 * exact. Velocities are in px/s, y down. Known velocities of real cameras were measured in the recordings by hand, or
 * by the camera's gyro.
 */
enum RealExperiments {
    /** A pan whose velocity is known from the camera's gyro. */
    BOXES("boxes-translation.aedat", null, RealExperiments::boxes),
    /** Three cars. */
    CARS("cars.aedat", null, RealExperiments::cars),
    /** Two rows of stripes. */
    STRIPES("stripes.aedat", null, RealExperiments::stripes),
    /** A ball on a pendulum. */
    PENDULUM_BALL("pendulum-ball.aedat", null, RealExperiments::pendulumBall),
    /** A square outline that a program drew. */
    SQUARE("synthetic-square.aedat", "DAVIS240C", RealExperiments::square);

    private static final IntPredicate ALL = i -> true;
    private static final String TIME = "time, s";
    private static final String VX = "median velocity to the right, px/s";

    // boxes-translation: the gyro's range is 1000 deg/s, and the lens has 4.5 mm on pixels of 18.5 um. The offset is
    // that with which the gyro's samples give the known velocities of the recording, 27.7, 25.1, 28.8 and 28.0 px/s at
    // the four times.
    private static final double GYRO_LSB_PER_DEG_PER_S = 32.8;
    private static final double PX_PER_DEG = 4.245;
    private static final double GYRO_OFFSET_DEG_PER_S = -1.13;
    // Velocity by pairs of events of one polarity that lie 0.08 to 0.2 s apart: their most frequent displacement in 19
    // windows of 0.25 s, as a line over the gyro's velocity. The displacements differ from the line by 0.2 px/s.
    private static final double PAIRS_PER_GYRO = 1.098;
    private static final double PAIRS_OFFSET_PX_PER_S = -1.17;
    private static final double[] BOXES_TIMES_S = {0.3, 0.8, 1.3, 1.8};
    private static final double BOXES_WINDOW_S = 0.1;
    private static final double BOXES_BIN_S = 0.05;

    private static final double CARS_HALF_WINDOW_S = 0.05;
    private static final double CARS_BIN_S = 0.05;
    private static final int CAR_FEWEST_EVENTS = 50;
    private static final int CAR_SEGMENTS = 6;
    private static final List<Sighting> SIGHTINGS = List.of(new Sighting("A", 0.5, 88, -29),
        new Sighting("A", 1, 88, -29), new Sighting("A", 1.65, 88, -29), new Sighting("B", 1.65, 28, -10),
        new Sighting("C", 1.65, -75, 32));

    private static final double[] STRIPES_TIMES_S = {0.3, 0.6, 0.9};
    private static final double STRIPES_BIN_S = 0.05;
    private static final int UPPER_ROWS_END = 64;
    private static final int LOWER_ROWS_START = 73;

    private final String fileName;
    private final String chip;
    private final Function<LabelledRecording, RealExperiment> experiment;

    /** Makes the experiment of a file; the chip is null if the recording names it. */
    RealExperiments(String fileName, String chip, Function<LabelledRecording, RealExperiment> experiment) {
        this.fileName = fileName;
        this.chip = chip;
        this.experiment = experiment;
    }

    /** A car at one time, and its known velocity. */
    private record Sighting(String car, double timeS, double vx, double vy) {
        String title() {
            return String.format(Locale.ROOT, "%s at %.2f s: (%.0f, %.0f)", car, timeS, vx, vy);
        }
    }

    /** The velocity of a segment over a window. */
    private record SegmentMotion(int id, double vx, double vy) {
        double offPercent(Sighting sighting) {
            return 100 * Math.hypot(vx - sighting.vx, vy - sighting.vy) / Math.hypot(sighting.vx, sighting.vy);
        }

        String against(Sighting sighting) {
            return String.format(Locale.ROOT, "(%.0f, %.0f), %.0f %% off, segment %d", vx, vy, offPercent(sighting),
                id);
        }
    }

    String fileName() {
        return fileName;
    }

    /** Runs every method on the recording. */
    RealExperiment on(Path file) throws EventSourceException {
        return experiment.apply(LabelledRecording.of(file, chip));
    }

    private static RealExperiment boxes(LabelledRecording recording) {
        List<String> header = new ArrayList<>(List.of("", "with flow"));
        double[] truth = new double[BOXES_TIMES_S.length];
        List<String> gyroRow = new ArrayList<>(List.of("gyro", ""));
        List<String> pairsRow = new ArrayList<>(List.of("pairs of events", ""));
        double pairsSquares = 0;
        for (int i = 0; i < truth.length; i++) {
            truth[i] = gyroVx(recording, BOXES_TIMES_S[i], BOXES_TIMES_S[i] + BOXES_WINDOW_S);
            header.add(number(1, BOXES_TIMES_S[i]) + " s");
            gyroRow.add(number(1, truth[i]));
            double pairs = PAIRS_PER_GYRO * truth[i] + PAIRS_OFFSET_PX_PER_S;
            pairsRow.add(number(1, pairs));
            pairsSquares += (pairs - truth[i]) * (pairs - truth[i]);
        }
        header.add("RMS error");
        gyroRow.add("");
        pairsRow.add(number(1, Math.sqrt(pairsSquares / truth.length)) + " px/s");
        List<List<String>> rows = new ArrayList<>(List.of(gyroRow, pairsRow));
        List<Goal.Check> checks = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            double share = 100 * recording.shareWithFlow(method);
            List<String> row = new ArrayList<>(List.of(method.title(), percent(1, share)));
            double squares = 0;
            for (int i = 0; i < truth.length; i++) {
                double vx = recording.medianVx(method, BOXES_TIMES_S[i], BOXES_TIMES_S[i] + BOXES_WINDOW_S, ALL);
                squares += (vx - truth[i]) * (vx - truth[i]);
                row.add(number(1, vx));
                if (method == ComparedMethod.SOFAS_DEFAULT) {
                    checks.add(new Goal.Check("velocity at " + number(1, BOXES_TIMES_S[i]) + " s",
                        "within 1 px/s of " + number(1, truth[i]), number(1, vx) + " px/s",
                        Math.abs(vx - truth[i]) <= 1));
                }
            }
            row.add(number(1, Math.sqrt(squares / truth.length)) + " px/s");
            rows.add(row);
            if (method == ComparedMethod.SOFAS_DEFAULT) {
                checks.add(new Goal.Check("events with flow", "≥ 80 %", percent(1, share), share >= 80));
            }
        }
        List<Plot.Line> lines = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            lines.add(new Plot.Line(method.title(), Plot.Ink.of(method),
                recording.medianVxCurve(method, BOXES_BIN_S, ALL)));
        }
        lines.add(new Plot.Line("gyro", Plot.Ink.TRUTH, gyroCurve(recording)));
        return new RealExperiment(BOXES.fileName, "Textured boxes before a slowly panned DAVIS240C. The true velocity "
            + "to the right is the gyro's rate about the vertical, less its offset of -1.13 deg/s, at 4.245 px a "
            + "degree. Medians over all events with flow, in windows of 0.1 s from the time named. Pairs of events of "
            + "one polarity, 0.08 to 0.2 s apart, move 1.5 px/s faster than the gyro says: 0.8 in the upper third of "
            + "the picture and 1.8 in the lower, as the camera rolls too, and 1.4 in the middle third of its width, so "
            + "that it is not what a lens does beside its axis. What follows the events misses the gyro by as much.",
            header, rows, checks, List.of(new Plot("boxes-translation", "Velocity to the right", TIME, VX, lines)));
    }

    private static double gyroVx(LabelledRecording recording, double fromS, double untilS) {
        double sum = 0;
        int n = 0;
        for (ImuSample sample : recording.imuSamples()) {
            double timeS = recording.timeS(sample);
            if (timeS >= fromS && timeS < untilS) {
                sum += -sample.gyroY() / GYRO_LSB_PER_DEG_PER_S - GYRO_OFFSET_DEG_PER_S;
                n++;
            }
        }
        return n == 0 ? Double.NaN : sum / n * PX_PER_DEG;
    }

    private static Curve gyroCurve(LabelledRecording recording) {
        int bins = (int) Math.ceil(recording.durationS() / BOXES_BIN_S);
        double[] middles = new double[bins];
        double[] values = new double[bins];
        for (int b = 0; b < bins; b++) {
            middles[b] = (b + 0.5) * BOXES_BIN_S;
            values[b] = gyroVx(recording, b * BOXES_BIN_S, (b + 1) * BOXES_BIN_S);
        }
        return new Curve(middles, values);
    }

    private static RealExperiment cars(LabelledRecording recording) {
        List<ComparedMethod> methods = List.of(ComparedMethod.SOFAS_DEFAULT, ComparedMethod.SOFAS_PAPER);
        List<String> header = new ArrayList<>(List.of("car, velocity"));
        List<String> shares = new ArrayList<>(List.of("with flow"));
        for (ComparedMethod method : methods) {
            header.add(method.title());
            shares.add(percent(1, 100 * recording.shareWithFlow(method)));
        }
        List<List<String>> rows = new ArrayList<>(List.of(shares));
        List<Goal.Check> checks = new ArrayList<>();
        Map<String, Set<Integer>> idsByCar = new HashMap<>();
        for (Sighting sighting : SIGHTINGS) {
            List<String> row = new ArrayList<>(List.of(sighting.title()));
            for (ComparedMethod method : methods) {
                SegmentMotion nearest = nearest(segments(recording, method, sighting.timeS - CARS_HALF_WINDOW_S,
                    sighting.timeS + CARS_HALF_WINDOW_S), sighting);
                String found = nearest == null ? "none" : nearest.against(sighting);
                row.add(found);
                if (method == ComparedMethod.SOFAS_DEFAULT) {
                    checks.add(new Goal.Check("car " + sighting.title(), "within 10 %", found,
                        nearest != null && nearest.offPercent(sighting) <= 10));
                    idsByCar.computeIfAbsent(sighting.car, car -> new HashSet<>())
                        .add(nearest == null ? 0 : nearest.id);
                }
            }
            rows.add(row);
        }
        Set<Integer> ids = new HashSet<>();
        idsByCar.values().forEach(ids::addAll);
        boolean oneEach = ids.size() == idsByCar.size()
            && idsByCar.values().stream().allMatch(ofCar -> ofCar.size() == 1);
        checks.add(new Goal.Check("segments of the cars", "one each", oneEach ? "one each" : "not one each", oneEach));
        return new RealExperiment(CARS.fileName, "A road with three cars before a static DAVIS346. Velocities of the "
            + "segment nearest to each car's, in windows of 0.1 s. Below, the velocity to the right of the segments "
            + "with the most events. The other methods find no segments.", header, rows, checks,
            methods.stream().map(method -> segmentsPlot(recording, method)).toList());
    }

    private static List<SegmentMotion> segments(LabelledRecording recording, ComparedMethod method, double fromS,
                                                double untilS) {
        FlowEstimate estimate = recording.by(method);
        List<SegmentMotion> segments = new ArrayList<>();
        counts(recording, method, fromS, untilS).forEach((id, events) -> {
            if (events >= CAR_FEWEST_EVENTS) {
                IntPredicate own = i -> estimate.segment(i) == id;
                segments.add(new SegmentMotion(id, recording.medianVx(method, fromS, untilS, own),
                    recording.medianVy(method, fromS, untilS, own)));
            }
        });
        return segments;
    }

    private static Map<Integer, Integer> counts(LabelledRecording recording, ComparedMethod method, double fromS,
                                                double untilS) {
        FlowEstimate estimate = recording.by(method);
        Map<Integer, Integer> counts = new HashMap<>();
        for (int i = recording.firstAt(fromS); i < recording.size() && recording.timeS(i) < untilS; i++) {
            if (estimate.hasFlow(i)) {
                counts.merge(estimate.segment(i), 1, Integer::sum);
            }
        }
        return counts;
    }

    private static SegmentMotion nearest(List<SegmentMotion> segments, Sighting sighting) {
        SegmentMotion nearest = null;
        for (SegmentMotion segment : segments) {
            if (nearest == null || segment.offPercent(sighting) < nearest.offPercent(sighting)) {
                nearest = segment;
            }
        }
        return nearest;
    }

    private static Plot segmentsPlot(LabelledRecording recording, ComparedMethod method) {
        FlowEstimate estimate = recording.by(method);
        List<Plot.Line> lines = new ArrayList<>();
        counts(recording, method, 0, Double.POSITIVE_INFINITY).entrySet().stream()
            .sorted(Map.Entry.<Integer, Integer>comparingByValue().reversed()).limit(CAR_SEGMENTS)
            .sorted(Map.Entry.comparingByKey())
            .forEach(entry -> lines.add(new Plot.Line("segment " + entry.getKey(), Plot.Ink.BY_PLACE,
                recording.medianVxCurve(method, CARS_BIN_S, i -> estimate.segment(i) == entry.getKey()))));
        return new Plot("cars-" + method.id(), method.title(), TIME, VX, lines);
    }

    private static RealExperiment stripes(LabelledRecording recording) {
        List<String> header = new ArrayList<>(List.of("", "with flow"));
        List<String> known = new ArrayList<>(List.of("known", ""));
        Map<ComparedMethod, List<String>> rowByMethod = new EnumMap<>(ComparedMethod.class);
        for (ComparedMethod method : ComparedMethod.values()) {
            rowByMethod.put(method, new ArrayList<>(List.of(method.title(),
                percent(1, 100 * recording.shareWithFlow(method)))));
        }
        List<Goal.Check> checks = new ArrayList<>();
        List<Plot> plots = new ArrayList<>();
        for (boolean upper : new boolean[] {true, false}) {
            String row = upper ? "upper" : "lower";
            IntPredicate picks = i -> upper ? recording.y(i) < UPPER_ROWS_END : recording.y(i) >= LOWER_ROWS_START;
            for (double timeS : STRIPES_TIMES_S) {
                double truth = stripesVx(upper, timeS, recording.durationS());
                header.add(row + ", " + number(1, timeS) + " s");
                known.add(number(0, truth));
                rowByMethod.forEach((method, cells) ->
                    cells.add(number(0, recording.medianVx(method, timeS - 0.05, timeS + 0.05, picks))));
                double ours = recording.medianVx(ComparedMethod.SOFAS_DEFAULT, timeS - 0.05, timeS + 0.05, picks);
                checks.add(new Goal.Check(row + " row at " + number(1, timeS) + " s",
                    "within 10 % of " + number(0, truth), number(0, ours) + " px/s",
                    Math.abs(ours - truth) <= 0.1 * Math.abs(truth)));
            }
            List<Plot.Line> lines = new ArrayList<>();
            for (ComparedMethod method : ComparedMethod.values()) {
                lines.add(new Plot.Line(method.title(), Plot.Ink.of(method),
                    recording.medianVxCurve(method, STRIPES_BIN_S, picks)));
            }
            double[] timesS = lines.get(0).x();
            lines.add(new Plot.Line("known", Plot.Ink.TRUTH, timesS, Arrays.stream(timesS)
                .map(timeS -> stripesVx(upper, timeS, recording.durationS())).toArray()));
            plots.add(new Plot("stripes-" + row, upper ? "Upper row" : "Lower row", TIME, VX, lines));
        }
        List<List<String>> rows = new ArrayList<>(List.of(known));
        rows.addAll(rowByMethod.values());
        return new RealExperiment(STRIPES.fileName, "Two rows of stripes moving to the left at two falling speeds "
            + "before a DVS128: -97 to -80 px/s above, -181 to -140 px/s below, taken as falling evenly. The velocity "
            + "along the stripes is undefined.", header, rows, checks, plots);
    }

    private static double stripesVx(boolean upper, double timeS, double durationS) {
        double gone = timeS / durationS;
        return upper ? -97 + 17 * gone : -181 + 41 * gone;
    }

    private static RealExperiment pendulumBall(LabelledRecording recording) {
        List<List<String>> rows = new ArrayList<>();
        List<Plot> plots = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            rows.add(List.of(method.title(), percent(1, 100 * recording.shareWithFlow(method))));
            plots.add(new Plot("pendulum-ball-" + method.id(), method.title(), TIME, VX,
                List.of(new Plot.Line(method.title(), Plot.Ink.of(method),
                    recording.medianVxCurve(method, 0.1, ALL)))));
        }
        return new RealExperiment(PENDULUM_BALL.fileName, "A ball on a pendulum before a static, noisy background, "
            + "seen by a DVS128. Its true velocity is not known; it should look like a sine.",
            List.of("", "with flow"), rows, List.of(), plots);
    }

    private static RealExperiment square(LabelledRecording recording) {
        List<List<String>> rows = new ArrayList<>();
        List<Goal.Check> checks = new ArrayList<>();
        for (ComparedMethod method : ComparedMethod.values()) {
            double vx = recording.medianVx(method, 0, Double.POSITIVE_INFINITY, ALL);
            double vy = recording.medianVy(method, 0, Double.POSITIVE_INFINITY, ALL);
            double off = 100 * Math.hypot(vx - 20, vy + 20) / Math.hypot(20, 20);
            rows.add(List.of(method.title(), percent(1, 100 * recording.shareWithFlow(method)), number(2, vx),
                number(2, vy), percent(1, off)));
            if (method == ComparedMethod.SOFAS_DEFAULT) {
                checks.add(new Goal.Check("velocity", "within 1 % of (20, -20)",
                    String.format(Locale.ROOT, "(%.2f, %.2f) px/s", vx, vy), off <= 1));
            }
        }
        return new RealExperiment(SQUARE.fileName, "The outline of a square that a program moves by exactly (20, -20) "
            + "px/s. Medians over all events with flow.", List.of("", "with flow", "to the right, px/s",
                "downwards, px/s", "off"), rows, checks, List.of());
    }

    private static String percent(int decimals, double value) {
        return Double.isNaN(value) ? "–" : number(decimals, value) + " %";
    }

    private static String number(int decimals, double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, "%." + decimals + "f", value);
    }
}
