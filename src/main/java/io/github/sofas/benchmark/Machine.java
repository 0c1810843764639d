package io.github.sofas.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.RuntimeMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The machine that the figures were taken on.
 *
 * @param cpu model of the processor, or its architecture if the system does not report the model
 * @param cores number of cores that the program may use
 * @param memoryBytes memory of the machine
 * @param os name, version and architecture of the operating system
 * @param jvm name and version of the Java virtual machine
 * @param jvmOptions options that the virtual machine was started with
 * @param maxHeapBytes largest heap that the virtual machine may use
 * @param load other work: the system's load average over the last minute at the start; negative if the system has none
 */
public record Machine(String cpu, int cores, long memoryBytes, String os, String jvm, List<String> jvmOptions,
                      long maxHeapBytes, double load) {
    private static final Path LINUX_CPU = Path.of("/proc/cpuinfo");
    private static final String WINDOWS_CPU = "PROCESSOR_IDENTIFIER";

    /** Describes the machine that this program runs on. */
    public static Machine here() {
        RuntimeMXBean jvm = ManagementFactory.getRuntimeMXBean();
        var system = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        String os = system.getName() + " " + system.getVersion() + " " + system.getArch();
        return new Machine(cpuHere(), system.getAvailableProcessors(), system.getTotalMemorySize(), os,
            jvm.getVmName() + " " + jvm.getVmVersion(), jvm.getInputArguments(), Runtime.getRuntime().maxMemory(),
            system.getSystemLoadAverage());
    }

    private static String cpuHere() {
        String otherwise = Optional.ofNullable(System.getenv(WINDOWS_CPU)).orElse(System.getProperty("os.arch"));
        if (!Files.isReadable(LINUX_CPU)) {
            return otherwise;
        }
        try (Stream<String> lines = Files.lines(LINUX_CPU, StandardCharsets.UTF_8)) {
            return cpu(lines).orElse(otherwise);
        } catch (IOException e) {
            return otherwise;
        }
    }

    /** Returns the first model name in the lines of Linux's cpuinfo. */
    static Optional<String> cpu(Stream<String> cpuinfo) {
        return cpuinfo.filter(line -> line.startsWith("model name")).findFirst()
            .map(line -> line.substring(line.indexOf(':') + 1).strip());
    }
}
