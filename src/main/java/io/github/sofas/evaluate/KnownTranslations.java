package io.github.sofas.evaluate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Cache of the best single translations of windows. The search takes most of the time of measuring sharpness, but its
 * result depends on the events alone and can be reused for other methods. Several threads may share one instance.
 */
public final class KnownTranslations {
    private static final String NUMBER = "(-?\\d+(?:\\.\\d+)?(?:E-?\\d+)?)";
    /** A line: key of the window, then the velocity. The name of the recording may contain commas. */
    private static final Pattern LINE = Pattern.compile("(.*,-?\\d+,-?\\d+,\\d+)," + NUMBER + "," + NUMBER);
    private static final String HEADER = "recording,from_us,until_us,events,vx_px_per_s,vy_px_per_s";

    private final Map<String, double[]> velocities = new TreeMap<>();

    /**
     * Reads the translations of a file, if the file exists. Lines that {@link #write} did not write are skipped; the
     * translations of their windows are searched again.
     *
     * @param file the file
     * @return the translations of the file; none if the file does not exist
     * @throws IOException if the file cannot be read
     */
    public static KnownTranslations read(Path file) throws IOException {
        KnownTranslations known = new KnownTranslations();
        if (Files.exists(file)) {
            for (String line : Files.readAllLines(file)) {
                known.add(line);
            }
        }
        return known;
    }

    private void add(String line) {
        Matcher parts = LINE.matcher(line);
        if (parts.matches()) {
            velocities.put(parts.group(1), new double[] {Double.parseDouble(parts.group(2)),
                Double.parseDouble(parts.group(3))});
        }
    }

    /**
     * Writes one line per window: recording, first and last time, number of events, and velocity.
     *
     * @param file the file
     * @throws IOException if the file cannot be written
     */
    public synchronized void write(Path file) throws IOException {
        StringBuilder lines = new StringBuilder(HEADER).append('\n');
        velocities.forEach((window, v) -> lines.append(window).append(',').append(v[0]).append(',').append(v[1])
            .append('\n'));
        Files.writeString(file, lines);
    }

    /** Gives a translation the known velocity of a window, or has the translation find and store the velocity. */
    void take(String recording, MovedEvents window, SingleTranslation translation) {
        String key = recording + "," + window.firstUs() + "," + window.lastUs() + "," + window.size();
        double[] known;
        synchronized (this) {
            known = velocities.get(key);
        }
        if (known != null) {
            translation.take(window, known[0], known[1]);
            return;
        }
        translation.find(window);
        synchronized (this) {
            velocities.put(key, new double[] {translation.vxPxPerS(), translation.vyPxPerS()});
        }
    }
}
