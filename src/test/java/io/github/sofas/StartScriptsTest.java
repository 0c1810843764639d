package io.github.sofas;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Runs {@code gradlew} and {@code sofas} in a folder of their own, with a Gradle and a Java that only print. */
public class StartScriptsTest {
    private static final List<String> TOOLS = List.of("sh", "awk", "cat", "chmod", "dirname", "env", "find", "grep",
        "id", "mkdir", "mktemp", "mv", "readlink", "rm", "sed", "sha256sum", "sleep", "touch", "unzip");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private final Map<String, String> environment = new TreeMap<>();
    private Path root;
    private Path project;
    /** As {@code ./gradlew installDist} makes it. */
    private Path program;

    @Before
    public void copiesTheScriptsAndHidesTheMachine() throws IOException {
        if (!Files.isExecutable(Path.of("/bin/sh"))) {
            throw Skipped.because("there is no /bin/sh");
        }
        root = folder.getRoot().toPath().toRealPath();
        project = Files.createDirectories(root.resolve("project"));
        program = project.resolve("build/install/sofas");
        Files.createDirectories(project.resolve("gradle"));
        Files.createDirectories(project.resolve("src/main"));
        Files.createDirectories(project.resolve("plugins/jaer/src/main"));
        Files.createDirectories(project.resolve("plugins/jaer/src/generator"));
        for (String name : List.of("gradlew", "sofas", "gradle/jdk.sh", "build.gradle", "settings.gradle",
            "gradle.properties", "plugins/jaer/build.gradle")) {
            Files.copy(Path.of(name), project.resolve(name));
        }
        Path bin = Files.createDirectories(root.resolve("bin"));
        for (String tool : TOOLS) {
            for (String where : List.of("/usr/bin", "/bin")) {
                Path real = Path.of(where, tool);
                if (Files.exists(real) && !Files.exists(bin.resolve(tool))) {
                    Files.createSymbolicLink(bin.resolve(tool), real);
                }
            }
        }
        environment.put("PATH", bin.toString());
        environment.put("HOME", root.toString());
    }

    @Test
    public void takesTheGradleOnPathAndPassesTheArguments() throws Exception {
        Path java = installJava("jdk-17", "17.0.15");
        Path gradle = installGradleOnPath("8.5", "echo \"$JAVA_HOME $1 $2 $4 $5\"");
        environment.put("JAVA_HOME", java.toString());

        Result result = run("gradlew", "compileJava", "two words");

        assertEquals("gradlew: Gradle 8.5 in " + gradle + " on JDK 17 in " + java + "\n", result.err);
        assertEquals(java + " -p " + project + " compileJava two words\n", result.out);
        assertEquals(0, result.code);
    }

    @Test
    public void passesOverTheJdkThatThisGradleDoesNotRunOn() throws Exception {
        // Gradle 8.5 runs on 21 and older, bytecode for 17 needs 17 and newer.
        environment.put("JAVA_HOME", installJava("jdk-25", "25.0.1").toString());
        installJava(".jdks/a-jdk-8", "1.8.0_392");
        Path java = installJava(".jdks/b-jdk-21", "21.0.2");
        Path gradle = installGradleOnPath("8.5", "echo \"$JAVA_HOME\"");

        Result result = run("gradlew", "test");

        assertEquals("gradlew: Gradle 8.5 in " + gradle + " on JDK 21 in " + java + "\n", result.err);
        assertEquals(java + "\n", result.out);
    }

    @Test
    public void printsTheSumOfAllModulesLastAndKeepsTheExitCode() throws Exception {
        environment.put("JAVA_HOME", installJava("jdk-17", "17.0.15").toString());
        installGradleOnPath("8.11.1", "file=${3#-PtestCounts=}\n"
            + "echo '5 passed, 0 failed, 1 skipped' >>\"$file\"\n"
            + "echo '7 passed, 2 failed, 0 skipped' >>\"$file\"\n"
            + "echo BUILD FAILED\n"
            + "exit 3");

        Result result = run("gradlew", "test");

        assertEquals("BUILD FAILED\n12 passed, 2 failed, 1 skipped\n", result.out);
        assertEquals(3, result.code);
    }

    @Test
    public void takesNoDistributionWithAnotherChecksum() throws Exception {
        Path java = installJava("jdk-17", "17.0.15");
        environment.put("JAVA_HOME", java.toString());
        Path gradle = installGradleOnPath("9.0.0", "echo used");
        // curl -fsSL --connect-timeout 10 -o FILE URL: writes an empty file
        script(root.resolve("bin/curl"), ": >\"$5\"");

        Result result = run("gradlew", "test");

        String[] lines = result.err.split("\n");
        assertEquals("gradlew: Gradle 9.0.0 in " + gradle
            + " does not serve: 7.3 to 8 or Debian's 4.4.1 would", lines[0]);
        // the SHA-256 of nothing
        assertEquals("gradlew: its SHA-256 is e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
            + " but must be f397b287023acdba1e9f6fc5ea72d22dd63669d59ed4a289a29b1a76eee151c6; not used", lines[2]);
        assertEquals("gradlew: the pinned Gradle 8.11.1 could not be obtained", lines[3]);
        assertEquals("", result.out);
        assertEquals(1, result.code);
        try (var left = Files.list(root.resolve(".cache/sofas"))) {
            assertEquals("files left in the cache", List.of(), left.toList());
        }
    }

    @Test
    public void usesThePinnedDistributionWhereItIsInTheCache() throws Exception {
        Path java = installJava("jdk-17", "17.0.15");
        environment.put("JAVA_HOME", java.toString());
        Path gradle = root.resolve(".cache/sofas/gradle-8.11.1");
        installGradle(gradle, "8.11.1", "echo \"pinned $4\"");

        Result result = run("gradlew", "test");

        assertEquals("gradlew: Gradle 8.11.1 in " + gradle + " on JDK 17 in " + java + "\n", result.err);
        assertEquals("pinned test\n", result.out);
    }

    @Test
    public void installsDebiansPackageWhereNothingElseServes() throws Exception {
        Path java = installJava("jdk-17", "17.0.15");
        environment.put("JAVA_HOME", java.toString());
        script(root.resolve("bin/id"), "echo 0");
        Path gradle = root.resolve("later");
        installGradle(gradle, "8.5", "echo \"installed $4\"");
        script(root.resolve("bin/apt-get"), "case \"$*\" in *install*gradle*)"
            + " /bin/ln -s '" + gradle.resolve("bin/gradle") + "' '" + root.resolve("bin/gradle") + "' ;; esac");

        Result result = run("gradlew", "test");

        assertEquals("gradlew: fetching https://services.gradle.org/distributions/gradle-8.11.1-bin.zip\n"
            + "gradlew: neither curl nor wget to fetch it with\n"
            + "gradlew: the pinned Gradle 8.11.1 could not be obtained\n"
            + "gradlew: no Gradle and JDK here can build SOFAS: installing Debian's packages gradle "
            + "openjdk-17-jdk-headless by apt-get (SOFAS_NO_INSTALL=1 forbids it)\n"
            + "gradlew: Gradle 8.5 in " + gradle + " on JDK 17 in " + java + "\n", result.err);
        assertEquals("installed test\n", result.out);
    }

    @Test
    public void installsNothingWhereTheUserForbidsIt() throws Exception {
        environment.put("JAVA_HOME", installJava("jdk-17", "17.0.15").toString());
        environment.put("SOFAS_NO_INSTALL", "1");
        script(root.resolve("bin/id"), "echo 0");
        script(root.resolve("bin/apt-get"), ": >'" + root.resolve("installed") + "'");

        Result result = run("gradlew", "test");

        assertEquals("gradlew: SOFAS_NO_INSTALL forbids to install gradle openjdk-17-jdk-headless by apt-get",
            result.err.split("\n")[3]);
        assertFalse("apt-get was called", Files.exists(root.resolve("installed")));
        assertEquals(1, result.code);
    }

    @Test
    public void runsTheProgramWithItsArgumentsAndExitCode() throws Exception {
        Path java = installJava("jdk-21", "21.0.2");
        environment.put("SOFAS_JAVA", java.toString());
        markBuilt();
        Path link = Files.createSymbolicLink(root.resolve("link"), project.resolve("sofas"));

        Result result = runScript(link, "run", "two words");

        assertEquals("", result.err);
        assertEquals("-XX:+UseSerialGC\n--enable-native-access=ALL-UNNAMED\n-cp\n" + program + "/lib/*\n"
            + "io.github.sofas.cli.Main\nrun\ntwo words\n", result.out);
        assertEquals(7, result.code);
    }

    @Test
    public void keepsTheClassesAsJavaHoldsThemOnce() throws Exception {
        Path java = installJava("jdk-21", "21.0.2");
        Path calls = root.resolve("calls");
        // keeps classes where it is asked to, in a file that is not to be written, as Java does
        script(java.resolve("bin/java"), "echo \"$*\" >>" + calls + "\n"
            + "case $2 in -XX:ArchiveClassesAtExit=*) echo classes >\"${2#*=}\"; chmod 444 \"${2#*=}\" ;; esac");
        environment.put("SOFAS_JAVA", java.toString());
        markBuilt();
        run("sofas", "info", "two words");
        run("sofas", "info");

        String lib = " -cp " + program + "/lib/* io.github.sofas.cli.Main ";
        String options = "-XX:+UseSerialGC --enable-native-access=ALL-UNNAMED -XX:SharedArchiveFile=" + program
            + "/lib/classes.jsa -Xlog:cds*=off";
        List<String> lines = Files.readAllLines(calls);
        assertEquals(List.of(options + lib + "info two words", options + lib + "info"), lines.subList(1, 3));
        String keeping = "-XX:+UseSerialGC -XX:ArchiveClassesAtExit=" + program + "/lib/classes.jsa.";
        assertEquals(List.of(0), IntStream.range(0, lines.size())
            .filter(i -> lines.get(i).startsWith(keeping) && lines.get(i).contains(lib + "render ")).boxed().toList());
    }

    @Test
    public void namesOfFilesAreUtf8InThePlainLocaleAndElseAsTheUserHasThem() throws Exception {
        Path java = installJava("jdk-21", "21.0.2");
        script(java.resolve("bin/java"), "echo \"$LC_ALL\"");
        environment.put("SOFAS_JAVA", java.toString());
        markBuilt();
        assertEquals("C.UTF-8\n", run("sofas", "run").out);
        environment.put("LC_ALL", "POSIX");
        environment.put("LANG", "de_DE.UTF-8");
        assertEquals("C.UTF-8\n", run("sofas", "run").out);
        environment.put("LC_ALL", "");
        assertEquals("\n", run("sofas", "run").out);
        environment.put("LC_ALL", "de_DE.ISO-8859-1");
        assertEquals("de_DE.ISO-8859-1\n", run("sofas", "run").out);
    }

    @Test
    public void buildsOnceAfterASourceChanged() throws Exception {
        environment.put("SOFAS_JAVA", installJava("jdk-21", "21.0.2").toString());
        script(project.resolve("gradlew"), "echo \"gradlew $*\"");
        markBuilt();
        Files.writeString(project.resolve("src/main/New.java"), "");

        assertEquals("sofas: building (the first time takes a minute)\ngradlew -q installDist\n",
            run("sofas", "run").err);
        assertEquals("", run("sofas", "run").err);
    }

    @Test
    public void ofTwoThatFindNothingBuiltOneBuildsAndTheOtherWaits() throws Exception {
        environment.put("SOFAS_JAVA", installJava("jdk-21", "21.0.2").toString());
        script(project.resolve("gradlew"), "echo built >>\"" + root.resolve("builds") + "\"; sleep 2");
        markBuilt();
        Files.writeString(project.resolve("src/main/New.java"), "");
        Result[] other = new Result[1];
        Thread thread = new Thread(() -> {
            try {
                other[0] = run("sofas", "run");
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
        thread.start();
        Result result = run("sofas", "run");
        thread.join();
        assertEquals(List.of("built"), Files.readAllLines(root.resolve("builds")));
        assertEquals(List.of(7, 7), List.of(result.code, other[0].code));
        assertFalse("the lock is given back", Files.exists(project.resolve("build/install.lock")));
    }

    @Test
    public void lockOfABuildThatWasKilledIsTakenOver() throws Exception {
        environment.put("SOFAS_JAVA", installJava("jdk-21", "21.0.2").toString());
        script(project.resolve("gradlew"), "true");
        markBuilt();
        Files.writeString(project.resolve("src/main/New.java"), "");
        Files.createDirectories(project.resolve("build/install.lock"));
        // no process has so great a number
        Files.writeString(project.resolve("build/install.lock/process"), "99999999\n");
        Result result = run("sofas", "run");
        assertEquals("sofas: building (the first time takes a minute)\n", result.err);
        assertEquals(7, result.code);
    }

    /** What the program says without Spark, and that it was started with it. */
    private void installJavaForBatches(int codeWithoutSpark) throws IOException {
        Path java = installJava("jdk-21", "21.0.2");
        script(java.resolve("bin/java"), "case \" $* \" in *SparkBatch*) printf '%s\\n' \"$@\"; exit 7;; esac\n"
            + "exit " + codeWithoutSpark);
        environment.put("SOFAS_JAVA", java.toString());
        Files.createDirectories(project.resolve("plugins/spark/src/main"));
        Files.copy(Path.of("plugins/spark/build.gradle"), project.resolve("plugins/spark/build.gradle"));
        markBuilt();
    }

    @Test
    public void batchFetchesSparkOnceAndRunsOnIt() throws Exception {
        installJavaForBatches(69);
        Path spark = root.resolve(".cache/sofas/spark-4.0.4");
        script(project.resolve("gradlew"), "echo \"gradlew $*\"; mkdir -p '" + spark + "'; : >'" + spark
            + "/complete'");

        Result first = run("sofas", "batch", "a b.aedat");

        assertEquals("sofas: fetching Spark into " + spark
            + " (225 MB, once; checked against gradle/dependencies.sha256)"
            + "\ngradlew -q :plugins:spark:fetchSpark\n", first.err);
        assertTrue(first.out, first.out.endsWith("-cp\n" + project + "/plugins/spark/build/libs/sofas-spark.jar:"
            + spark
            + "/*\nio.github.sofas.spark.SparkBatch\na b.aedat\n"));
        assertEquals(7, first.code);
        assertEquals("", run("sofas", "batch", "a.aedat").err);
    }

    @Test
    public void batchTakesTheSparkThatIsThere() throws Exception {
        installJavaForBatches(69);
        environment.put("SPARK_HOME", "/opt/spark");
        script(project.resolve("gradlew"), "echo \"gradlew $*\"");

        Result result = run("sofas", "batch", "a.aedat");

        assertEquals("gradlew -q :plugins:spark:jar\n", result.err);
        assertTrue(result.out, result.out.contains("sofas-spark.jar:/opt/spark/jars/*\n"));
    }

    @Test
    public void batchFetchesNothingForWrongUsage() throws Exception {
        installJavaForBatches(2);
        script(project.resolve("gradlew"), "echo \"gradlew $*\"");

        Result result = run("sofas", "batch", "--nonsense");

        assertEquals("", result.err);
        assertEquals(2, result.code);
    }

    @Test
    public void buildsInUtf8WhereTheLocaleIsPlainForFoldersOfAnyName() throws Exception {
        environment.put("JAVA_HOME", installJava("jdk-17", "17.0.15").toString());
        installGradleOnPath("8.5", "echo \"$LC_ALL\"");
        environment.put("LC_ALL", "C");
        assertEquals("C.UTF-8\n", run("gradlew", "compileJava").out);
        environment.put("LC_ALL", "de_DE.UTF-8");
        assertEquals("de_DE.UTF-8\n", run("gradlew", "compileJava").out);
    }

    @Test
    public void runsNothingWhereTheBuildFails() throws Exception {
        environment.put("SOFAS_JAVA", installJava("jdk-21", "21.0.2").toString());
        script(project.resolve("gradlew"), "echo \"Main.java:3: error\" >&2; exit 5");

        for (int attempt = 1; attempt <= 2; attempt++) {
            Result result = run("sofas", "run");

            assertEquals("sofas: building (the first time takes a minute)\nMain.java:3: error\n"
                + "sofas: the build failed\n", result.err);
            assertEquals("", result.out);
            assertEquals(1, result.code);
        }
    }

    @Test
    public void refusesAnOldJava() throws Exception {
        Path java = installJava("jdk-11", "11.0.22");
        environment.put("SOFAS_JAVA", java.toString());
        markBuilt();

        Result result = run("sofas", "run");

        assertEquals("sofas: SOFAS_JAVA must be Java 17 or newer but is 11: " + java + "\n", result.err);
        assertEquals(1, result.code);
    }

    /** A Java that prints its arguments one a line and exits with 7. */
    private Path installJava(String name, String version) throws IOException {
        Path home = Files.createDirectories(root.resolve(name));
        Files.createDirectories(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "IMPLEMENTOR=\"Test\"\nJAVA_VERSION=\"" + version + "\"\n");
        script(home.resolve("bin/java"), "printf '%s\\n' \"$@\"; exit 7");
        script(home.resolve("bin/javac"), "");
        return home;
    }

    private Path installGradleOnPath(String version, String commands) throws IOException {
        Path home = root.resolve("gradle-" + version);
        installGradle(home, version, commands);
        Files.createSymbolicLink(root.resolve("bin/gradle"), home.resolve("bin/gradle"));
        return home;
    }

    private static void installGradle(Path home, String version, String commands) throws IOException {
        Files.createDirectories(home.resolve("bin"));
        Files.createDirectories(home.resolve("lib"));
        Files.createFile(home.resolve("lib/gradle-core-" + version + ".jar"));
        Files.createFile(home.resolve("lib/gradle-core-api-" + version + ".jar"));
        script(home.resolve("bin/gradle"), commands);
    }

    private static void script(Path file, String commands) throws IOException {
        Files.deleteIfExists(file);
        Files.writeString(file, "#!/bin/sh\n" + commands + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    /** As after a build: everything of the project is an hour older than the mark. */
    private void markBuilt() throws IOException {
        FileTime hourAgo = FileTime.fromMillis(System.currentTimeMillis() - TimeUnit.HOURS.toMillis(1));
        try (var files = Files.walk(project)) {
            for (Path file : files.toList()) {
                Files.setLastModifiedTime(file, hourAgo);
            }
        }
        for (String name : List.of("bin/sofas", "lib/jdk.sh")) {
            Path file = program.resolve(name);
            Files.createDirectories(file.getParent());
            Files.copy(name.startsWith("bin") ? Path.of("src/main/dist", name) : Path.of("gradle/jdk.sh"), file);
        }
        Files.createFile(project.resolve("build/install/built"));
        Files.setLastModifiedTime(project.resolve("build/install/built"),
            FileTime.fromMillis(hourAgo.toMillis() + TimeUnit.MINUTES.toMillis(1)));
    }

    private Result run(String script, String... arguments) throws Exception {
        return runScript(project.resolve(script), arguments);
    }

    private Result runScript(Path script, String... arguments) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(script.toString());
        builder.command().addAll(List.of(arguments));
        builder.directory(Path.of("/").toFile());
        builder.environment().clear();
        builder.environment().putAll(environment);
        Path out = root.resolve("out.txt");
        Path err = root.resolve("err.txt");
        builder.redirectOutput(out.toFile()).redirectError(err.toFile());
        int code = builder.start().waitFor();
        return new Result(code, Files.readString(out), Files.readString(err));
    }

    private record Result(int code, String out, String err) {
    }
}
