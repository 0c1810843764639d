package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedSource;
import io.github.sofas.simulate.SimulationOptions;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Recordings for a benchmark without recordings of the user: simulated scenes, which are the same on every machine. A
 * short scene is filmed in several passes, until there are enough events to time. Between two passes, its objects jump
 * back.
 */
public final class BuiltInScenes {
    private static final SensorSize DAVIS346 = new SensorSize(346, 260);
    private static final SensorSize LARGEST = new SensorSize(SensorSize.MAX_WIDTH, SensorSize.MAX_HEIGHT);
    private static final double NOISE_HZ_PER_PX = 5;
    private static final long NOISE_US = 2_200_000;
    /** Events per pixel of the sensor and per px that the textured wall travels, approximately. */
    private static final double WALL_EVENTS_PER_PX = 0.155;
    private static final double WALL_PX_PER_S = 120;
    /** Standard deviations of the log intensity of walls with two fifths and with three times the usual contrast. */
    private static final double FAINT_WALL_SD = 0.11;
    private static final double STRONG_WALL_SD = 0.9;

    private static final SensorSize HD = new SensorSize(1280, 720);

    private static final List<BuiltIn> ALL = all();

    /** A built-in scene. Its passes make about a million events in all, or more on large sensors. */
    private record BuiltIn(String name, Scene scene, SimulationOptions options, int passes) {
        String fullName() {
            return name + " (simulated, " + options.sensor() + ")";
        }
    }

    private BuiltInScenes() {
    }

    private static List<BuiltIn> all() {
        List<BuiltIn> all = new ArrayList<>(sparse());
        SensorSize davis240 = SimulationOptions.DAVIS240;
        for (double millionPerS : new double[] {0.35, 1, 5}) {
            all.add(wall(davis240, millionPerS, 1));
        }
        for (double millionPerS : new double[] {0.35, 1, 5}) {
            all.add(wall(DAVIS346, millionPerS, 1.5));
        }
        all.add(wall("faint textured-pan", FAINT_WALL_SD));
        all.add(wall("strong textured-pan", STRONG_WALL_SD));
        all.add(wall(HD, 10, 2.5));
        all.add(wall(HD, 50, 4));
        return List.copyOf(all);
    }

    /** A wall at the speed that gives {@code millionPerS} million events/s, for {@code millions} million events. */
    private static BuiltIn wall(SensorSize sensor, double millionPerS, double millions) {
        SimulationOptions options = SimulationOptions.defaults().withSensor(sensor)
            .withSpeedPxPerS(millionPerS * 1e6 / pixels(sensor) / WALL_EVENTS_PER_PX)
            .withDurationUs(Math.round(millions / millionPerS * 1e6));
        String rate = millionPerS < 1 ? Double.toString(millionPerS) : Long.toString(Math.round(millionPerS));
        return new BuiltIn("textured-pan of " + rate + " million/s", Scene.TEXTURED_PAN, options, 1);
    }

    /** A wall of another contrast, which gives more or fewer events per pixel of travel. */
    private static BuiltIn wall(String name, double sd) {
        return new BuiltIn(name, Scene.TEXTURED_PAN, SimulationOptions.defaults().withSensor(DAVIS346)
            .withSpeedPxPerS(WALL_PX_PER_S).withTexture(sd).withDurationUs(1_000_000), 1);
    }

    private static List<BuiltIn> sparse() {
        SimulationOptions davis = SimulationOptions.defaults();
        // Both sensors get the same duration and the same total noise, so that only the sensor's size differs.
        SimulationOptions small = davis.withDurationUs(Scene.HEXAGON.durationUs(davis));
        double noise = davis.dvs().noiseHzPerPx() * pixels(davis.sensor()) / pixels(LARGEST);
        SimulationOptions large = small.withSensor(LARGEST).withDvs(davis.dvs().withNoiseHzPerPx(noise));
        return List.of(
            new BuiltIn("hexagon", Scene.HEXAGON, small, 15),
            new BuiltIn("hexagon", Scene.HEXAGON, large, 15),
            new BuiltIn("sixteen", Scene.SIXTEEN, davis, 8),
            new BuiltIn("three-crossing", Scene.THREE_CROSSING, davis, 11),
            new BuiltIn("four-bars", Scene.FOUR_BARS, davis, 3),
            new BuiltIn("noise of 5 Hz/px", Scene.NOISE, davis.withSensor(DAVIS346).withDurationUs(NOISE_US)
                .withDvs(davis.dvs().withNoiseHzPerPx(NOISE_HZ_PER_PX)), 1));
    }

    private static double pixels(SensorSize sensor) {
        return (double) sensor.width() * sensor.height();
    }

    /** Names of the scenes, in the order in which they are measured. */
    public static List<String> names() {
        return ALL.stream().map(BuiltIn::fullName).toList();
    }

    /**
     * Simulates a scene and writes it as a recording.
     *
     * @param name one of {@link #names}
     * @param folder folder for the file of the recording
     * @throws IOException if the file cannot be written
     */
    public static RecordingUnderTest film(String name, Path folder) throws IOException {
        BuiltIn builtIn = ALL.stream().filter(each -> each.fullName().equals(name)).findFirst().orElseThrow();
        Path file = folder.resolve(builtIn.scene.sceneName() + "-" + builtIn.options.sensor());
        try (EventSource source = new SimulatedSource(builtIn.scene, builtIn.options, builtIn.passes)) {
            return write(name, source, file);
        } catch (EventSourceException e) {
            throw new IllegalStateException("a simulated scene has no damage", e);
        }
    }

    /** Writes the events as AEDAT 2.0 if that format has a chip of the sensor's size, and as text otherwise. */
    private static RecordingUnderTest write(String name, EventSource source, Path withoutExtension)
            throws IOException, EventSourceException {
        SensorSize sensor = source.sensor();
        EventBatch batch = new EventBatch(Benchmark.BATCH);
        for (Chip chip : Chip.known()) {
            if (chip.sensor().equals(sensor)) {
                Path file = withoutExtension.resolveSibling(withoutExtension.getFileName() + ".aedat");
                try (Aedat2Writer writer = new Aedat2Writer(file, chip)) {
                    while (source.next(batch)) {
                        writer.write(batch);
                    }
                }
                return new RecordingUnderTest(name, file, RecordingOptions.defaults());
            }
        }
        Path file = withoutExtension.resolveSibling(withoutExtension.getFileName() + ".txt");
        try (BufferedWriter writer = Files.newBufferedWriter(file)) {
            while (source.next(batch)) {
                for (int i = 0; i < batch.size(); i++) {
                    writer.write(line(batch, i));
                }
            }
        }
        return new RecordingUnderTest(name, file, RecordingOptions.defaults().withChip(sensor.toString()));
    }

    private static String line(EventBatch batch, int i) {
        long timeUs = batch.timeUs[i];
        return timeUs / 1_000_000 + "." + Long.toString(1_000_000 + timeUs % 1_000_000).substring(1)
            + " " + batch.x[i] + " " + batch.y[i] + " " + batch.polarity[i] + "\n";
    }
}
