package io.github.sofas;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A project that is no part of this one depends on the published core, as its user's would. */
public class OutsideProjectTest {
    private static final Path REPOSITORY = Path.of(System.getProperty("sofas.repository", "build/repository"));
    private static final String VERSION = System.getProperty("sofas.version", "");
    private static final Path CORE = REPOSITORY.resolve("io/github/sofas/sofas-core").resolve(VERSION);

    /** An edge, 40 px long, moves right at 100 px/s. */
    private static final String PROGRAM = """
        import io.github.sofas.event.EventBatch;
        import io.github.sofas.event.SensorSize;
        import io.github.sofas.flow.FlowOutput;
        import io.github.sofas.flow.Sofas;
        import io.github.sofas.flow.SofasParameters;

        class Outside {
            public static void main(String[] args) {
                Sofas sofas = new Sofas(new SensorSize(240, 180), SofasParameters.defaults());
                EventBatch batch = new EventBatch(40);
                FlowOutput flow = new FlowOutput(40);
                int labelled = 0;
                for (int x = 20; x < 220; x++) {
                    batch.clear();
                    for (int y = 60; y < 100; y++) {
                        batch.add(x * 10_000L + y, x, y, 1);
                    }
                    sofas.process(batch, flow);
                    for (int i = 0; i < batch.size(); i++) {
                        labelled += flow.segment[i] != 0 ? 1 : 0;
                    }
                }
                System.out.println(labelled > 4000 ? "most events have flow" : labelled + " of 8000 events have flow");
            }
        }
        """;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void theCoreComesWithSourcesAndJavadocAndNeedsNothing() throws IOException {
        if (!Files.isDirectory(CORE)) {
            throw Skipped.because("nothing was published: these tests were not started by Gradle");
        }
        try (Stream<Path> files = Files.list(CORE)) {
            Set<String> names = files.map(file -> file.getFileName().toString())
                .filter(name -> name.endsWith(".jar") || name.endsWith(".pom")).collect(Collectors.toSet());
            String base = "sofas-core-" + VERSION;
            assertEquals(Set.of(base + ".jar", base + ".pom", base + "-sources.jar", base + "-javadoc.jar"), names);
        }
        String pom = Files.readString(CORE.resolve("sofas-core-" + VERSION + ".pom"));
        assertFalse(pom, pom.contains("<dependency>"));
        assertTrue(pom, pom.contains("LGPL-2.1-or-later") && pom.contains("the SOFAS authors")
            && pom.contains("<scm>"));
        try (JarFile jar = new JarFile(CORE.resolve("sofas-core-" + VERSION + ".jar").toFile())) {
            assertEquals("io.github.sofas.core", jar.getManifest().getMainAttributes()
                .getValue("Automatic-Module-Name"));
            Set<String> packages = jar.stream().map(entry -> entry.getName()).filter(name -> name.endsWith(".class"))
                .map(name -> name.split("/")[3]).collect(Collectors.toCollection(TreeSet::new));
            assertEquals(Set.of("event", "flow"), packages);
        }
    }

    @Test
    public void aMavenProjectBuildsAndRuns() throws Exception {
        Path maven = onPath("mvn");
        if (!Files.isDirectory(CORE) || maven == null) {
            throw Skipped.because(maven == null ? "there is no Maven" : "nothing was published");
        }
        write("src/main/java/Outside.java", PROGRAM);
        write("pom.xml", """
            <project xmlns="http://maven.apache.org/POM/4.0.0">
              <modelVersion>4.0.0</modelVersion>
              <groupId>outside</groupId><artifactId>outside</artifactId><version>1</version>
              <properties>
                <maven.compiler.source>17</maven.compiler.source>
                <maven.compiler.target>17</maven.compiler.target>
                <project.build.sourceEncoding>UTF-8</project.build.sourceEncoding>
              </properties>
              <repositories><repository><id>build</id><url>%s</url></repository></repositories>
              <dependencies><dependency>
                <groupId>io.github.sofas</groupId><artifactId>sofas-core</artifactId><version>%s</version>
              </dependency></dependencies>
            </project>
            """.formatted(REPOSITORY.toUri(), VERSION));
        // kept from run to run for Maven's own plugins, but not for what is tested
        Path local = REPOSITORY.resolveSibling("outside-maven").toAbsolutePath();
        delete(local.resolve("io/github/sofas"));

        Result built = run(maven.toString(), "-q", "-B", "-Dmaven.repo.local=" + local, "compile");
        if (built.out.contains("(https://repo.maven.apache.org/maven2)") && built.out.contains("transfer")) {
            throw Skipped.because("Maven cannot reach Maven Central for its plugins");
        }
        assertEquals(built.out, 0, built.code);
        Path jar = local.resolve("io/github/sofas/sofas-core").resolve(VERSION).resolve("sofas-core-" + VERSION
            + ".jar");
        Result ran = run(java(), "-cp", "target/classes" + File.pathSeparator + jar, "Outside");
        assertEquals("most events have flow\n", ran.out);
    }

    /** By the Gradle that runs this test, which is any that the build supports. */
    @Test
    public void aGradleProjectBuildsAndRuns() throws Exception {
        Path gradle = Path.of(System.getProperty("sofas.gradleHome", "none")).resolve("bin/gradle");
        if (!Files.isDirectory(CORE) || !Files.isExecutable(gradle)) {
            throw Skipped.because("there is no " + gradle);
        }
        write("src/main/java/Outside.java", PROGRAM);
        write("settings.gradle", "rootProject.name = 'outside'\n");
        write("build.gradle", """
            apply plugin: 'java'
            repositories {
                maven { url '%s' }
            }
            dependencies {
                implementation 'io.github.sofas:sofas-core:%s'
            }
            task outside(type: Exec, dependsOn: classes) {
                commandLine '%s', '-cp', sourceSets.main.runtimeClasspath.asPath, 'Outside'
            }
            """.formatted(REPOSITORY.toUri(), VERSION, java()));

        Result ran = run(gradle.toString(), "-q", "--offline", "--no-daemon", "outside");

        assertEquals(ran.out, 0, ran.code);
        assertTrue(ran.out, ran.out.endsWith("most events have flow\n"));
    }

    private static Path onPath(String program) {
        for (String part : System.getenv("PATH").split(File.pathSeparator)) {
            Path file = Path.of(part, program);
            if (Files.isExecutable(file)) {
                return file;
            }
        }
        return null;
    }

    private static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    private void write(String name, String text) throws IOException {
        Path file = folder.getRoot().toPath().resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private static void delete(Path root) throws IOException {
        if (!Files.exists(root)) {
            return;
        }
        Files.walkFileTree(root, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path directory, IOException fault) throws IOException {
                Files.delete(directory);
                return FileVisitResult.CONTINUE;
            }
        });
    }

    private Result run(String... command) throws Exception {
        File out = folder.newFile();
        ProcessBuilder builder = new ProcessBuilder(List.of(command)).directory(folder.getRoot())
            .redirectErrorStream(true).redirectOutput(out);
        builder.environment().putAll(Map.of("JAVA_HOME", System.getProperty("java.home")));
        int code = builder.start().waitFor();
        return new Result(code, Files.readString(out.toPath()).replace("\r\n", "\n"));
    }

    private record Result(int code, String out) {
    }
}
