package io.github.sofas.host;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** A display for jAER, whose chips draw even where nobody looks: that of the user, else one without a screen. */
public final class Display implements AutoCloseable {
    private final String name;
    private final Process server;

    private Display(String name, Process server) {
        this.name = name;
        this.server = server;
    }

    /**
     * Finds the display that the environment names, else starts Xvfb. Windows and macOS need neither.
     *
     * @param named value of DISPLAY, or null
     * @throws JaerException where there is none to be had
     */
    public static Display open(String named) throws JaerException {
        String system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        if (named != null && !named.isEmpty() || system.startsWith("windows") || system.startsWith("mac")) {
            return new Display(named == null ? "" : named, null);
        }
        try {
            // it says the number that it chose as soon as it listens
            Process server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1024x768x24")
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
            String number = new BufferedReader(
                new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII)).readLine();
            if (number != null) {
                return new Display(":" + number.trim(), server);
            }
            server.destroy();
        } catch (IOException e) {
            // not installed: as if it had not answered
        }
        throw new JaerException("jAER needs a display: set DISPLAY, or install Xvfb, which is then used");
    }

    /** What a process finds it by; empty where none is needed. */
    String name() {
        return name;
    }

    /** Stops what was started. */
    @Override
    public void close() {
        if (server != null) {
            server.destroy();
        }
    }
}
