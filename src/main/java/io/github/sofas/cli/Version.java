package io.github.sofas.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The program's version, as the build wrote it. */
final class Version implements IVersionProvider {
    /** The version as results name it. */
    static String text() {
        Properties properties = new Properties();
        try (InputStream file = Version.class.getResourceAsStream("/io/github/sofas/version.properties")) {
            properties.load(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return properties.getProperty("version");
    }

    @Override
    public String[] getVersion() {
        return new String[] {"sofas " + text(), "Java " + Runtime.version()};
    }
}
