package io.github.sofas;

import io.github.sofas.cli.FileFuzz;
import io.github.sofas.cli.ParameterFuzz;
import io.github.sofas.evaluate.TruthCsvFuzz;
import io.github.sofas.export.FlowCsvFuzz;
import io.github.sofas.flow.EngineFuzz;
import io.github.sofas.live.LiveFuzz;
import io.github.sofas.recording.ReaderFuzz;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Everything that takes bytes from outside, as targets for the fuzzer Jazzer: classes with a method
 * {@code fuzzerTestOneInput(byte[])} that throws where a rule is broken, and {@code seeds()}, valid inputs to start
 * from. {@code ./gradlew fuzz -PfuzzSeconds=600}
 */
public final class FuzzTargets {
    static final List<Class<?>> ALL = List.of(ReaderFuzz.Aedat1.class, ReaderFuzz.Aedat2Dvs128.class,
        ReaderFuzz.Aedat2Davis.class, ReaderFuzz.Aedat3.class, ReaderFuzz.Aedat4.class, ReaderFuzz.Lz4.class,
        ReaderFuzz.Evt.class, ReaderFuzz.Dat.class, ReaderFuzz.EventStream.class, ReaderFuzz.NMnist.class,
        ReaderFuzz.Hdf5.class,
        ReaderFuzz.Text.class, ReaderFuzz.Detection.class, LiveFuzz.Davis.class, LiveFuzz.Dvs128.class,
        LiveFuzz.Datagrams.class, FlowCsvFuzz.class, TruthCsvFuzz.class, FileFuzz.BiasesFile.class,
        FileFuzz.EarlierSummary.class, ParameterFuzz.class, EngineFuzz.class);

    private FuzzTargets() {
    }

    /** Fuzzes each target, or those named, in a Java of its own: folder of corpora and findings, seconds, names. */
    public static void main(String[] args) throws IOException, InterruptedException {
        Path folder = Path.of(args[0]);
        List<String> names = List.of(args).subList(2, args.length);
        List<String> found = new ArrayList<>();
        for (Class<?> target : ALL) {
            if ((names.isEmpty() || names.contains(target.getSimpleName()))
                    && !passes(target, folder.resolve(target.getSimpleName()), args[1])) {
                found.add(target.getSimpleName());
            }
        }
        if (!found.isEmpty()) {
            System.err.println("findings in " + String.join(", ", found) + "; inputs and messages are in " + folder);
            System.exit(1);
        }
    }

    private static boolean passes(Class<?> target, Path folder, String seconds)
            throws IOException, InterruptedException {
        Path corpus = Files.createDirectories(folder.resolve("corpus"));
        List<byte[]> seeds = seeds(target);
        for (int i = 0; i < seeds.size(); i++) {
            Files.write(corpus.resolve("seed-" + i), seeds.get(i));
        }
        Path log = folder.resolve("log.txt");
        System.out.println(target.getSimpleName() + ": " + seconds + " s");
        int code = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx1g",
            "-cp", System.getProperty("java.class.path"), "com.code_intelligence.jazzer.Jazzer",
            "--target_class=" + target.getName(), "--instrumentation_includes=io.github.sofas.**",
            "--reproducer_path=" + folder, "-artifact_prefix=" + folder + "/", "-max_total_time=" + seconds,
            "-max_len=8192", "-print_final_stats=1", corpus.toString())
            .redirectErrorStream(true).redirectOutput(log.toFile()).start().waitFor();
        for (String line : Files.readAllLines(log)) {
            if (line.contains("Exception") || line.startsWith("stat::number_of_executed_units")) {
                System.out.println("  " + line);
            }
        }
        return code == 0;
    }

    @SuppressWarnings("unchecked")
    static List<byte[]> seeds(Class<?> target) {
        try {
            return (List<byte[]>) target.getMethod("seeds").invoke(null);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("every target has seeds", e);
        }
    }

    /** Gives an input to a target; what it throws is thrown. */
    static void run(Class<?> target, byte[] input) {
        try {
            target.getMethod("fuzzerTestOneInput", byte[].class).invoke(null, input);
        } catch (InvocationTargetException e) {
            throw new AssertionError(target.getName() + ": " + e.getCause(), e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("every target has fuzzerTestOneInput", e);
        }
    }
}
