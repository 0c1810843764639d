package io.github.sofas.spark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat2Writer;
import io.github.sofas.recording.Chip;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.hadoop.ParquetReader;
import org.apache.parquet.hadoop.example.GroupReadSupport;

/** A batch in a process of its own, as {@code ./sofas batch} or {@code spark-submit} starts it, and what it makes. */
final class Submitted {
    /** What differs from run to run in a summary. */
    private static final Pattern MEASURED =
        Pattern.compile("\"(wall|decode|engine|output|events_per_second|peak_heap_bytes)\" : [\\d.]+");

    /** Runs for seconds: compiling more than once takes longer than it saves. */
    private static final List<String> BRIEF_JAVA = List.of(java(), "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");

    private final Process process;
    private final Path err;

    private Submitted(Process process, Path err) {
        this.process = process;
        this.err = err;
    }

    /** What it came to. */
    record Result(int exitCode, List<String> errLines) {
    }

    /** Starts a batch with settings for Spark such as {@code spark.ui.enabled=false}. */
    static Submitted start(Path folder, List<String> settings, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(BRIEF_JAVA);
        command.addAll(List.of("-Dlog4j2.configurationFile=classpath:io/github/sofas/spark/log4j2.properties",
            "-Dspark.ui.enabled=false"));
        settings.forEach(setting -> command.add("-D" + setting));
        command.addAll(List.of("-cp", sparkClassPath(), SparkBatch.class.getName()));
        command.addAll(List.of(arguments));
        return start(folder, command, Map.of());
    }

    /** Runs a batch to its end in {@code local[2]}. */
    static Result batch(Path folder, String... arguments) throws IOException, InterruptedException {
        List<String> all = new ArrayList<>(List.of(arguments));
        all.addAll(List.of("--master", "local[2]"));
        return start(folder, List.of(), all.toArray(String[]::new)).await();
    }

    /** Runs the command {@code run}, without Spark. */
    static Result run(Path folder, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(BRIEF_JAVA);
        command.addAll(List.of("-cp", System.getProperty("sofas.program.classPath"),
            "io.github.sofas.cli.Main", "run"));
        command.addAll(List.of(arguments));
        return start(folder, command, Map.of()).await();
    }

    /** Starts any program. */
    static Submitted start(Path folder, List<String> command, Map<String, String> environment) throws IOException {
        Path err = Files.createTempFile(folder, "err", ".txt");
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(err.toFile());
        builder.environment().putAll(environment);
        return new Submitted(builder.start(), err);
    }

    static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    /** The plugin, Spark, and the file systems of these tests. */
    static String sparkClassPath() {
        String tests = Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .filter(each -> new File(each, "io/github/sofas/spark/StoreFileSystem.class").exists())
            .findFirst().orElseThrow();
        return String.join(File.pathSeparator, System.getProperty("sofas.spark.jar"),
            System.getProperty("sofas.spark.classPath"), tests);
    }

    Process process() {
        return process;
    }

    Result await() throws IOException, InterruptedException {
        int exitCode = process.waitFor();
        return new Result(exitCode, Files.readAllLines(err));
    }

    /** Writes a recording of an edge that moves to the right, at 10 px/s. */
    static void writeRecording(Path file, int events) throws IOException {
        EventBatch batch = new EventBatch(events);
        for (int i = 0; i < events; i++) {
            batch.add(100L * i, 10 + i / 1000 % 100, 20 + i * 7 % 50, 1);
        }
        try (Aedat2Writer writer = new Aedat2Writer(file, Chip.named("DVS128").orElseThrow())) {
            writer.write(batch);
        }
    }

    /** The rows of {@code batch.parquet} by the names of the recordings; empty values are left out. */
    static Map<String, Map<String, String>> rows(Path table) throws IOException {
        Map<String, Map<String, String>> rows = new TreeMap<>();
        try (ParquetReader<Group> reader = ParquetReader.builder(new GroupReadSupport(),
                new org.apache.hadoop.fs.Path(table.toUri())).build()) {
            for (Group group = reader.read(); group != null; group = reader.read()) {
                Map<String, String> row = new LinkedHashMap<>();
                for (int i = 0; i < group.getType().getFieldCount(); i++) {
                    if (group.getFieldRepetitionCount(i) > 0) {
                        row.put(group.getType().getFieldName(i), group.getValueToString(i, 0));
                    }
                }
                rows.put(row.get("name"), row);
            }
        }
        return rows;
    }

    /** All files below a folder with their bytes, by their paths; what differs from run to run is taken out. */
    static Map<String, String> contents(Path folder) throws IOException {
        Map<String, String> contents = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = folder.relativize(file).toString();
                String text = Files.readString(file, StandardCharsets.ISO_8859_1);
                contents.put(name, name.endsWith(".summary.json") ? MEASURED.matcher(text).replaceAll("") : text);
            }
        }
        return contents;
    }
}
