package io.github.sofas.spark;

import io.github.sofas.batch.BatchProgram;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;

/**
 * Loads the program with its own libraries, isolated from those of Spark. The jar of this plugin holds the program's
 * jars, as they are installed elsewhere, in the folder {@value #FOLDER}. A class loader of their own loads them here.
 * It shares with Spark only the JDK and the package {@code io.github.sofas.batch}.
 *
 * <p>Spark has some of the libraries in other versions, which take precedence over those of an application. To rename
 * their packages is no solution: the native part of zstd-jni knows its classes by name, and some of the classes for
 * Parquet replace classes of Hadoop. With the same versions as everywhere, results have the same bytes as everywhere.
 */
final class IsolatedProgram {
    private static final String FOLDER = "program/";

    private IsolatedProgram() {
    }

    /** Holds the program, which is loaded at its first use, once in a process. */
    private static final class Loaded {
        private static final BatchProgram PROGRAM = load();
    }

    /** The program. */
    static BatchProgram get() {
        return Loaded.PROGRAM;
    }

    /** Parent loader: passes on the classes that both sides share, and no others of Spark's side. */
    private static final class Shared extends ClassLoader {
        private static final String PACKAGE = "io.github.sofas.batch.";

        Shared() {
            super(ClassLoader.getPlatformClassLoader());
        }

        @Override
        protected Class<?> findClass(String name) throws ClassNotFoundException {
            if (name.startsWith(PACKAGE)) {
                return IsolatedProgram.class.getClassLoader().loadClass(name);
            }
            throw new ClassNotFoundException(name);
        }
    }

    private static BatchProgram load() {
        try {
            ClassLoader loader = new URLClassLoader("sofas", libraries().toArray(URL[]::new), new Shared());
            return ServiceLoader.load(BatchProgram.class, loader).findFirst()
                .orElseThrow(() -> new IllegalStateException("sofas-spark.jar has no program in it"));
        } catch (IOException e) {
            throw new UncheckedIOException("the program in sofas-spark.jar cannot be unpacked", e);
        }
    }

    /** Unpacks the libraries for this process, because a class loader cannot read a jar inside another. */
    private static List<URL> libraries() throws IOException {
        Path folder = Files.createTempDirectory("sofas-program");
        folder.toFile().deleteOnExit();
        List<URL> libraries = new ArrayList<>();
        try (JarFile jar = new JarFile(ownJar().toFile())) {
            for (JarEntry entry : jar.stream().filter(each -> each.getName().startsWith(FOLDER)
                    && each.getName().endsWith(".jar")).toList()) {
                Path library = folder.resolve(entry.getName().substring(FOLDER.length()));
                Files.copy(jar.getInputStream(entry), library);
                library.toFile().deleteOnExit();
                libraries.add(library.toUri().toURL());
            }
        }
        return libraries;
    }

    private static Path ownJar() {
        try {
            return Path.of(IsolatedProgram.class.getProtectionDomain().getCodeSource().getLocation().toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException("a jar that was loaded has a place", e);
        }
    }
}
