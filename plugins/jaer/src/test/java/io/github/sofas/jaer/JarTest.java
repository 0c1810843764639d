package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import org.junit.Test;

/** What is shipped. */
public class JarTest {
    @Test
    public void holdsTheFilterAndTheCoreAndNothingElse() throws IOException {
        try (JarFile jar = new JarFile(System.getProperty("sofas.jaer.jar"))) {
            Set<String> packages = new TreeSet<>();
            jar.stream().filter(entry -> entry.getName().endsWith(".class"))
                .forEach(entry -> packages.add(entry.getName().substring(0, entry.getName().lastIndexOf('/'))));
            // of the engine whatever it is made of
            assertTrue(packages.contains("io/github/sofas/flow"));
            packages.removeIf(name -> name.startsWith("io/github/sofas/flow/"));
            assertEquals(Set.of("io/github/sofas/event", "io/github/sofas/export", "io/github/sofas/flow",
                "io/github/sofas/jaer"), packages);
            assertTrue(jar.getEntry("io/github/sofas/jaer/SofasFlow.class") != null);
            assertEquals("io.github.sofas.jaer.SofasAgent",
                jar.getManifest().getMainAttributes().getValue("Premain-Class"));
            assertEquals("io.github.sofas.jaer.StartJaer",
                jar.getManifest().getMainAttributes().getValue("Main-Class"));
        }
    }

    /** A handle resolves one method, as a caller does; reflection would ask for the classes of all. */
    @Test
    public void flowAndTracksAreWrittenWithNothingBeyondTheJar() throws Throwable {
        URL[] jar = {Path.of(System.getProperty("sofas.jaer.jar")).toUri().toURL()};
        try (URLClassLoader alone = new URLClassLoader(jar, ClassLoader.getPlatformClassLoader())) {
            Class<?> table = alone.loadClass("io.github.sofas.export.TrackTable");
            ByteArrayOutputStream flow = new ByteArrayOutputStream();
            MethodHandle writer = MethodHandles.publicLookup().findConstructor(
                alone.loadClass("io.github.sofas.export.FlowCsvWriter"),
                MethodType.methodType(void.class, OutputStream.class));
            ((Closeable) writer.invoke((OutputStream) flow)).close();
            assertEquals("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\n", flow.toString(StandardCharsets.UTF_8));
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            MethodHandle csv = MethodHandles.publicLookup().findStatic(table, "csv",
                MethodType.methodType(table, OutputStream.class));
            ((Closeable) csv.invoke((OutputStream) out)).close();
            assertEquals("t_us,segment,x,y,min_x,min_y,max_x,max_y,vx_px_per_s,vy_px_per_s,turn_rad_per_s,growth_per_s,"
                + "events\n", out.toString(StandardCharsets.UTF_8));
        }
    }
}
