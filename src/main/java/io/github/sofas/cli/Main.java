package io.github.sofas.cli;

import io.github.sofas.batch.Cluster;
import io.github.sofas.recording.Printable;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import picocli.CommandLine;

/** Entry point of the program: runs one command, prints what went wrong, and determines the exit code. */
public final class Main {
    /** Everything was done. */
    static final int OK = 0;
    /** A recording failed. */
    static final int FAILED = 1;
    /** Wrong usage; nothing was run. */
    static final int USAGE = 2;
    /** A batch has no cluster to run on; the code of sysexits.h for an unavailable service. */
    static final int NO_CLUSTER = 69;

    private Main() {
    }

    /** Runs one command and ends the program with its exit code. */
    public static void main(String[] args) {
        Charset charset = Charset.defaultCharset();
        int exitCode = execute(new PrintWriter(System.out, true, charset), new PrintWriter(System.err, true, charset),
            args);
        System.exit(exitCode);
    }

    /**
     * Runs one command.
     *
     * @param out receives the requested output: figures, help, versions
     * @param err receives progress, summaries and messages
     * @return the exit code: 0 done, 1 a recording failed, 2 wrong usage, {@value #NO_CLUSTER} no Spark to run on
     */
    static int execute(PrintWriter out, PrintWriter err, String... args) {
        return execute(null, out, err, args);
    }

    /** The same with a cluster for batches. */
    static int execute(Cluster cluster, PrintWriter out, PrintWriter err, String... args) {
        SofasCommand sofas = new SofasCommand(cluster);
        CommandLine commandLine = sofas.commandLine(args);
        commandLine.setOut(out);
        commandLine.setErr(err);
        commandLine.setUsageHelpAutoWidth(true);
        commandLine.setParameterExceptionHandler((exception, ignored) -> {
            UsageMessage.of(exception).lines().map(Printable::of).forEach(err::println);
            printSuggestions(args, err);
            err.println("Try '" + exception.getCommandLine().getCommandSpec().qualifiedName() + " --help'.");
            return USAGE;
        });
        commandLine.setExecutionStrategy(parsed -> {
            OnceEach.check(parsed);
            return new CommandLine.RunLast().execute(parsed);
        });
        commandLine.setExecutionExceptionHandler((exception, failed, ignored) -> {
            if (exception instanceof FailureException) {
                err.println(Printable.of(exception.getMessage()));
                return FAILED;
            }
            sofas.printUnexpected(err, "", exception);
            return FAILED;
        });
        int exitCode = commandLine.execute(SofasCommand.withoutHelpAll(args));
        // flushes, and shows whether anything was lost since the beginning
        boolean isLost = out.checkError();
        if (isLost) {
            err.println("standard output cannot be written: what was to be printed is lost");
        }
        err.flush();
        return isLost && exitCode == OK ? FAILED : exitCode;
    }

    /** Prints what the user may have meant, among all options, including those that the help leaves out. */
    private static void printSuggestions(String[] args, PrintWriter err) {
        try {
            new SofasCommand().commandLine(true, args).parseArgs(SofasCommand.withoutHelpAll(args));
        } catch (CommandLine.ParameterException e) {
            CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
        }
    }
}
