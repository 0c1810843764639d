package io.github.sofas.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Properties;

/** A Java properties file in UTF-8. Messages about a key name its line, and no key may stand twice. */
final class ConfigFile {
    /** More than any config file has, so that a recording named by mistake is refused. */
    private static final int MOST_BYTES = 1 << 20;

    private final Path file;
    private final Properties properties = new Properties() {
        private static final long serialVersionUID = 1L;

        /** Refuses a second value: otherwise the last one would count, silently. */
        @Override
        public synchronized Object put(Object key, Object value) {
            Object before = super.put(key, value);
            if (before != null) {
                throw new DoubleKeyException(String.valueOf(key));
            }
            return null;
        }
    };
    private final List<String> lines;

    private ConfigFile(Path file, List<String> lines) {
        this.file = file;
        this.lines = lines;
    }

    /**
     * Reads a file.
     *
     * @throws IllegalArgumentException if it cannot be read; the message is for the user
     */
    static ConfigFile read(Path file) {
        String name = "[" + file.getFileName() + "] ";
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(MOST_BYTES + 1);
            if (bytes.length > MOST_BYTES) {
                throw new IllegalArgumentException(name + "must have at most " + MOST_BYTES + " bytes but has more");
            }
            String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
            ConfigFile config = new ConfigFile(file, text.lines().toList());
            config.load(text, name);
            return config;
        } catch (NoSuchFileException e) {
            throw new IllegalArgumentException("[" + file + "] no such file", e);
        } catch (CharacterCodingException e) {
            throw new IllegalArgumentException(name + "must be text in UTF-8 but is not", e);
        } catch (IOException e) {
            throw new IllegalArgumentException(name + "cannot be read: " + e.getMessage(), e);
        }
    }

    /** Reports a key that stands twice. */
    private static final class DoubleKeyException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        DoubleKeyException(String key) {
            super(key);
        }
    }

    private void load(String text, String name) throws IOException {
        try {
            properties.load(new StringReader(text));
        } catch (DoubleKeyException e) {
            String key = e.getMessage();
            throw new IllegalArgumentException(place(key) + "\"" + key + "\" must stand once but stands twice", e);
        } catch (IllegalArgumentException e) {
            // Properties reports malformed \\u escapes in this way.
            throw new IllegalArgumentException(name + "cannot be read: " + e.getMessage(), e);
        }
    }

    /** All keys, in the order of the file. */
    List<String> keys() {
        List<String> keys = new ArrayList<>(properties.stringPropertyNames());
        keys.sort(Comparator.comparingInt(this::lineOf).thenComparing(Comparator.naturalOrder()));
        return keys;
    }

    /** The value of a key that exists. */
    String value(String key) {
        return properties.getProperty(key).strip();
    }

    /** File and line of a key, for the beginning of a message. */
    String place(String key) {
        int line = lineOf(key);
        return "[" + file.getFileName() + "] " + (line == 0 ? "" : "line " + line + ": ");
    }

    /** The last line with the key; 0 if the key is written with escapes. */
    private int lineOf(String key) {
        for (int i = lines.size(); i > 0; i--) {
            String line = lines.get(i - 1).stripLeading();
            if (line.startsWith(key)
                && (line.length() == key.length() || "=: \t".indexOf(line.charAt(key.length())) >= 0)) {
                return i;
            }
        }
        return 0;
    }
}
