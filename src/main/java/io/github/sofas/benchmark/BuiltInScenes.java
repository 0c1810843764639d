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
import java.util.List;

/**
 * Recordings for who names none: simulated scenes, the same on every machine. Each is filmed several times over, the
 * objects jumping back between two passes, until there are enough events to time.
 */
public final class BuiltInScenes {
    private static final SensorSize DAVIS346 = new SensorSize(346, 260);
    private static final SensorSize LARGEST = new SensorSize(SensorSize.MAX_WIDTH, SensorSize.MAX_HEIGHT);
    private static final double NOISE_HZ_PER_PX = 5;
    private static final long NOISE_US = 2_200_000;

    private static final List<BuiltIn> ALL = all();

    /** One of them; passes make about a million events. */
    private record BuiltIn(String name, Scene scene, SimulationOptions options, int passes) {
        String fullName() {
            return name + " (simulated, " + options.sensor() + ")";
        }
    }

    private BuiltInScenes() {
    }

    private static List<BuiltIn> all() {
        SimulationOptions davis = SimulationOptions.defaults();
        // As long on both sensors, and with as much noise in all, so that only the sensor's size differs.
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

    /** What they are called, in the order in which they are measured. */
    public static List<String> names() {
        return ALL.stream().map(BuiltIn::fullName).toList();
    }

    /**
     * Films one.
     *
     * @param name one of {@link #names}
     * @param folder that takes its file
     * @throws IOException where it cannot be written
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

    /** As AEDAT 2.0 where it has a chip of that size, else as text. */
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
