package io.github.sofas.host;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * A display for jAER, whose chips draw even if nobody watches. The display is the user's, or else that of an X server
 * without a screen (Xvfb), which this class starts and stops.
 */
public final class Display implements AutoCloseable {
    private final String name;
    private final Process server;

    private Display(String name, Process server) {
        this.name = name;
        this.server = server;
    }

    /**
     * Takes the display that the environment names, or else starts Xvfb. Windows and macOS need neither.
     *
     * @param named value of the environment variable DISPLAY, or null
     * @throws JaerException if there is no display and Xvfb cannot be started
     */
    public static Display open(String named) throws JaerException {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        if (named != null && !named.isEmpty() || system.startsWith("windows") || system.startsWith("mac")) {
            return new Display(named == null ? "" : named, null);
        }
        try {
            // Xvfb prints the number of the display that it chose as soon as it listens
            Process server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1024x768x24")
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            String number = new BufferedReader(
                new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII)).readLine();
            if (number != null) {
                return new Display(":" + number.trim(), server);
            }
            server.destroy();
        } catch (IOException e) {
            // Xvfb is not installed: treated as if it had not answered
        }
        throw new JaerException("jAER needs a display: set DISPLAY, or install Xvfb, which is then used");
    }

    /** Value of DISPLAY by which a process finds the display; empty if none is needed. */
    String name() {
        return name;
    }

    /** Stops Xvfb if it was started. */
    @Override
    public void close() {
        if (server != null) {
            server.destroy();
        }
    }
}
