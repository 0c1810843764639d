package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class JaerFolderTest {
    private static final String LISTS = "net/sf/jaer/util/allowed-subclasses/net.sf.jaer.eventprocessing.";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    /** A folder with a jAER.jar whose viewer is a class file of that version. */
    private Path jaer(int classFile, boolean lists) throws IOException {
        Path folder = temporary.newFolder().toPath();
        Files.createDirectories(folder.resolve("dist"));
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve("dist/jAER.jar")))) {
            jar.putNextEntry(new ZipEntry("net/sf/jaer/JAERViewer.class"));
            jar.write(new byte[] {(byte) 0xca, (byte) 0xfe, (byte) 0xba, (byte) 0xbe, 0, 0, 0, (byte) classFile});
            if (lists) {
                for (String kind : List.of("EventFilter2D", "EventFilter")) {
                    jar.putNextEntry(new ZipEntry(LISTS + kind + ".txt"));
                    jar.write(("a.First\nb.Last\n").getBytes());
                }
            }
        }
        return folder;
    }

    @Test
    public void refusesAFolderWithoutJaer() throws IOException {
        Path folder = temporary.newFolder().toPath();
        assertEquals("[" + folder + "] must be jAER's folder, with dist/jAER.jar or build/classes, but holds no"
            + " net/sf/jaer/JAERViewer.class",
            assertThrows(IOException.class, () -> JaerFolder.of(folder)).getMessage());
    }

    @Test
    public void knowsTheJavaThatItNeeds() throws IOException {
        // class files of version 65 are Java 21's
        assertEquals(21, JaerFolder.of(jaer(65, false)).leastJava());
    }

    @Test
    public void saysWhichJavaIsMissing() throws IOException {
        Path folder = jaer(99, false);
        assertEquals("[" + folder + "] needs Java 55 and brings none, but this is Java " + Runtime.version().feature(),
            assertThrows(IOException.class, () -> JaerFolder.of(folder).java()).getMessage());
    }

    @Test
    public void takesTheJavaThatComesWithIt() throws IOException {
        Path folder = jaer(99, false);
        String name = File.separatorChar == '\\' ? "java.exe" : "java";
        Path java = Files.createDirectories(folder.resolve("jre/bin")).resolve(name);
        assertTrue(Files.createFile(java).toFile().setExecutable(true));
        assertEquals(java.toAbsolutePath(), JaerFolder.of(folder).java());
    }

    @Test
    public void overlayNamesTheFilterAfterJaersOwn() throws IOException {
        Path overlay = temporary.newFolder().toPath();
        List<String> command = JaerFolder.of(jaer(61, true)).command(overlay, List.of("-Xmx1g"), "a.Main");
        assertEquals("a.First\nb.Last\nio.github.sofas.jaer.SofasFlow\n",
            Files.readString(overlay.resolve(LISTS + "EventFilter2D.txt")));
        assertEquals("a.First\nb.Last\nio.github.sofas.jaer.SofasFlow\n",
            Files.readString(overlay.resolve(LISTS + "EventFilter.txt")));
        String classPath = command.get(command.indexOf("-cp") + 1);
        assertTrue(classPath, classPath.startsWith(overlay + File.pathSeparator));
        assertTrue(classPath, classPath.endsWith("jAER.jar"));
        assertEquals("a.Main", command.get(command.size() - 1));
        assertTrue(command.contains("-Xmx1g"));
    }

    @Test
    public void releaseWithoutListsNeedsNoOverlay() throws IOException {
        Path overlay = temporary.newFolder().toPath();
        JaerFolder.of(jaer(61, false)).command(overlay, List.of(), "a.Main");
        assertEquals(0, overlay.toFile().list().length);
    }
}
