package io.github.sofas.jaer;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * A folder with jAER, installed or built. This class finds its jars and the Java that it needs, and makes the command
 * that starts jAER with the filter in its list, without a change to the folder.
 */
final class JaerFolder {
    /** Names of the lists from which jAER 3.3 reads its filters. */
    static final List<String> KINDS = List.of("net.sf.jaer.eventprocessing.EventFilter2D",
        "net.sf.jaer.eventprocessing.EventFilter");
    /**
     * The filter by its name: jAER's classes, and so the filter's class, cannot be loaded where jAER is only started.
     */
    private static final String FILTER = "io.github.sofas.jaer.SofasFlow";
    private static final String LISTS = "net/sf/jaer/util/allowed-subclasses/";
    private static final String VIEWER = "net/sf/jaer/JAERViewer.class";
    /** Class files of version n are for Java n - {@value}. */
    private static final int OLDEST_CLASS_FILE = 44;

    private final Path folder;
    private final List<Path> classPath;

    private JaerFolder(Path folder, List<Path> classPath) {
        this.folder = folder;
        this.classPath = classPath;
    }

    /**
     * Looks for jAER in a folder.
     *
     * @throws IOException if the folder holds no jAER, with a message for the user
     */
    static JaerFolder of(Path folder) throws IOException {
        List<Path> classPath = new ArrayList<>();
        Path classes = folder.resolve("build/classes");
        if (Files.isDirectory(classes)) {
            classPath.add(classes);
        }
        for (String jars : List.of("dist", "jars", "lib")) {
            if (Files.isDirectory(folder.resolve(jars))) {
                try (Stream<Path> files = Files.list(folder.resolve(jars))) {
                    files.filter(file -> file.toString().endsWith(".jar")).sorted().forEach(classPath::add);
                }
            }
        }
        JaerFolder found = new JaerFolder(folder.toAbsolutePath(), classPath);
        if (found.read(VIEWER) == null) {
            throw new IOException("[" + folder + "] must be jAER's folder, with dist/jAER.jar or build/classes,"
                + " but holds no " + VIEWER);
        }
        return found;
    }

    /** The content of a resource of jAER; null if there is none. */
    private byte[] read(String name) throws IOException {
        List<URL> urls = new ArrayList<>();
        for (Path entry : classPath) {
            urls.add(entry.toUri().toURL());
        }
        try (URLClassLoader loader = new URLClassLoader(urls.toArray(new URL[0]), null);
             InputStream in = loader.getResourceAsStream(name)) {
            return in == null ? null : in.readAllBytes();
        }
    }

    /** The oldest Java that runs this jAER, according to its class files. */
    int leastJava() throws IOException {
        byte[] viewer = read(VIEWER);
        return ((viewer[6] & 0xff) << 8 | viewer[7] & 0xff) - OLDEST_CLASS_FILE;
    }

    /**
     * The executable of the Java that comes with jAER, or else of the Java that runs this program.
     *
     * @throws IOException if the latter is too old, with a message for the user
     */
    Path java() throws IOException {
        String name = File.separatorChar == '\\' ? "java.exe" : "java";
        for (String home : List.of("jre", "jre.bundle/Contents/Home")) {
            Path bundled = folder.resolve(home).resolve("bin").resolve(name);
            if (Files.isExecutable(bundled)) {
                return bundled;
            }
        }
        if (Runtime.version().feature() < leastJava()) {
            throw new IOException("[" + folder + "] needs Java " + leastJava() + " and brings none, but this is Java "
                + Runtime.version().feature());
        }
        return Path.of(System.getProperty("java.home"), "bin", name);
    }

    /**
     * The command that starts a class with jAER and the filter on the class path. Lists of filters that name this
     * filter come before jAER's own on the class path, so that jAER finds them first.
     *
     * @param overlay a folder that these lists are written to
     */
    List<String> command(Path overlay, List<String> options, String mainClass) throws IOException {
        for (String kind : KINDS) {
            byte[] list = read(LISTS + kind + ".txt");
            if (list != null) {
                Path file = overlay.resolve(LISTS + kind + ".txt");
                Files.createDirectories(file.getParent());
                Files.writeString(file, new String(list, StandardCharsets.UTF_8).stripTrailing() + "\n"
                    + FILTER + "\n");
            }
        }
        List<String> entries = new ArrayList<>(List.of(overlay.toString(), ownJar().toString()));
        classPath.forEach(entry -> entries.add(entry.toString()));
        List<String> command = new ArrayList<>(List.of(java().toString()));
        command.addAll(options);
        if (leastJava() >= 21) {
            command.add("--enable-native-access=ALL-UNNAMED");
        }
        // packages that the drawing library and the viewer access
        for (String open : List.of("java.desktop/sun.awt", "java.desktop/sun.java2d", "java.base/java.lang")) {
            command.add("--add-exports=" + open + "=ALL-UNNAMED");
            command.add("--add-opens=" + open + "=ALL-UNNAMED");
        }
        command.addAll(List.of("-cp", String.join(File.pathSeparator, entries), mainClass));
        return command;
    }

    /** The jar, or the folder of classes, that holds this class. */
    private static Path ownJar() {
        try {
            return Path.of(JaerFolder.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    Path folder() {
        return folder;
    }
}
