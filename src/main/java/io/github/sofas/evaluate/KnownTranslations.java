package io.github.sofas.evaluate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Best single translations of windows that were searched before: the search takes most of the time that sharpness
 * takes, and depends on the events alone. Several threads may use one.
 */
public final class KnownTranslations {
    private static final String NUMBER = "(-?\\d+(?:\\.\\d+)?(?:E-?\\d+)?)";
    /** Window and velocity; the name of the recording may have commas. */
    private static final Pattern LINE = Pattern.compile("(.*,-?\\d+,-?\\d+,\\d+)," + NUMBER + "," + NUMBER);
    private static final String HEADER = "recording,from_us,until_us,events,vx_px_per_s,vy_px_per_s";

    private final Map<String, double[]> velocities = new TreeMap<>();

    /**
     * Reads those of a file, if it is there; what is not a line of {@link #write} is passed over and found anew.
     *
     * @param file the file
     * @return what the file holds; nothing where there is none
     * @throws IOException where it cannot be read
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
     * Writes them as lines of recording, first and last time of the window, its events, and the velocity.
     *
     * @param file the file
     * @throws IOException where the file cannot be written
     */
    public synchronized void write(Path file) throws IOException {
        StringBuilder lines = new StringBuilder(HEADER).append('\n');
        velocities.forEach((window, v) -> lines.append(window).append(',').append(v[0]).append(',').append(v[1])
            .append('\n'));
        Files.writeString(file, lines);
    }

    /** Lets a translation take what is known of a window, or find it. */
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
