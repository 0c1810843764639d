package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.List;
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
            assertEquals(new TreeSet<>(List.of("io/github/sofas/event", "io/github/sofas/export",
                "io/github/sofas/flow", "io/github/sofas/flow/fit", "io/github/sofas/flow/motion",
                "io/github/sofas/flow/paper", "io/github/sofas/flow/search", "io/github/sofas/flow/track",
                "io/github/sofas/jaer")), packages);
            assertTrue(jar.getEntry("io/github/sofas/jaer/SofasFlow.class") != null);
            assertEquals("io.github.sofas.jaer.SofasAgent",
                jar.getManifest().getMainAttributes().getValue("Premain-Class"));
            assertEquals("io.github.sofas.jaer.StartJaer",
                jar.getManifest().getMainAttributes().getValue("Main-Class"));
        }
    }
}
