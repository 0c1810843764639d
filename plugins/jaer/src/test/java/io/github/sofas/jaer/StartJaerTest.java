package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** The jar as its user runs it: without jAER's classes at hand. */
public class StartJaerTest {
    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private static String[] run(String... arguments) throws IOException, InterruptedException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        List<String> command = new ArrayList<>(List.of(java, "-jar", System.getProperty("sofas.jaer.jar")));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        return new String[] {Integer.toString(process.waitFor()), said};
    }

    /** A folder with a jAER whose viewer prints its first argument. */
    private Path jaer() throws IOException {
        return jaer(main -> {
            main.visitVarInsn(Opcodes.ALOAD, 0);
            main.visitInsn(Opcodes.ICONST_0);
            main.visitInsn(Opcodes.AALOAD);
        });
    }

    /** A folder with a jAER whose viewer prints a property of its Java. */
    private Path jaerThatPrints(String property) throws IOException {
        return jaer(main -> {
            main.visitLdcInsn(property);
            main.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/System", "getProperty",
                "(Ljava/lang/String;)Ljava/lang/String;", false);
        });
    }

    /** A folder with a jAER whose viewer prints what it is made to push. */
    private Path jaer(Consumer<MethodVisitor> push) throws IOException {
        ClassWriter viewer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        viewer.visit(Opcodes.V11, Opcodes.ACC_PUBLIC, "net/sf/jaer/JAERViewer", null, "java/lang/Object", null);
        MethodVisitor main = viewer.visitMethod(Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "main",
            "([Ljava/lang/String;)V", null, null);
        main.visitCode();
        main.visitFieldInsn(Opcodes.GETSTATIC, "java/lang/System", "out", "Ljava/io/PrintStream;");
        push.accept(main);
        main.visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/io/PrintStream", "println", "(Ljava/lang/String;)V", false);
        main.visitInsn(Opcodes.RETURN);
        main.visitMaxs(0, 0);
        main.visitEnd();
        Path folder = temporary.newFolder().toPath();
        Files.createDirectories(folder.resolve("dist"));
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve("dist/jAER.jar")))) {
            jar.putNextEntry(new ZipEntry("net/sf/jaer/JAERViewer.class"));
            jar.write(viewer.toByteArray());
            jar.putNextEntry(new ZipEntry("net/sf/jaer/util/allowed-subclasses/"
                + "net.sf.jaer.eventprocessing.EventFilter2D.txt"));
        }
        return folder;
    }

    @Test
    public void startsTheViewerWithTheRecording() throws Exception {
        Path recording = temporary.newFile("a.aedat").toPath();
        String[] result = run(jaer().toString(), recording.toString());
        assertEquals(recording.toAbsolutePath().toString(), result[1]);
        assertEquals("0", result[0]);
    }

    @Test
    public void handsOptionsToJaersJava() throws Exception {
        assertEquals("7", run("-Dsofas.test=7", "-Xmx64m", jaerThatPrints("sofas.test").toString())[1]);
    }

    @Test
    public void inertialSamplesReachTheFiltersUnlessTheUserSaysOtherwise() throws Exception {
        String property = "jaer.legacyExtractBundle";
        assertEquals("true", run(jaerThatPrints(property).toString())[1]);
        assertEquals("false", run("-D" + property + "=false", jaerThatPrints(property).toString())[1]);
    }

    @Test
    public void temporaryFolderGoesWhenItIsEndedByASignal() throws Exception {
        Path scratch = temporary.newFolder().toPath();
        // sleeps: the viewer waits for its standard input
        Path folder = jaer(main -> {
            main.visitFieldInsn(Opcodes.GETSTATIC, "java/lang/System", "in", "Ljava/io/InputStream;");
            main.visitMethodInsn(Opcodes.INVOKEVIRTUAL, "java/io/InputStream", "read", "()I", false);
            main.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/String", "valueOf", "(I)Ljava/lang/String;", false);
        });
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Djava.io.tmpdir=" + scratch, "-jar", System.getProperty("sofas.jaer.jar"), folder.toString()).start();
        while (process.children().findAny().isEmpty() && process.isAlive()) {
            Thread.sleep(20);
        }
        assertEquals(1, scratch.toFile().list().length);
        process.destroy();
        process.waitFor();
        assertEquals(0, scratch.toFile().list().length);
    }

    @Test
    public void saysHowItIsCalled() throws Exception {
        String[] result = run();
        assertEquals("usage: java -jar sofas-jAER.jar [JAVA_OPTION]... JAER_FOLDER [RECORDING]\n"
            + "Starts the jAER in a folder, with SOFAS among its filters. Options as -Xmx4g and -Dname=value go to its"
            + " Java.", result[1]);
        assertEquals("2", result[0]);
    }

    @Test
    public void saysThatARecordingIsMissing() throws Exception {
        String[] result = run(jaer().toString(), "no-such.aedat");
        assertEquals("[no-such.aedat] no such file, or not readable", result[1]);
        assertEquals("1", result[0]);
    }
}
