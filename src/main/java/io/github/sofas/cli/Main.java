package io.github.sofas.cli;

import io.github.sofas.batch.Cluster;
import io.github.sofas.recording.Printable;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import picocli.CommandLine;

/** Where the program starts. */
public final class Main {
    /** Everything was done. */
    static final int OK = 0;
    /** A recording failed. */
    static final int FAILED = 1;
    /** What was asked makes no sense; nothing was run. */
    static final int USAGE = 2;
    /** A batch that has nothing to run on; that of sysexits.h for a service that is not there. */
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
     * @param out gets what was asked for: figures, help, versions
     * @param err gets progress, summaries and messages
     * @return the exit code: 0 done, 1 a recording failed, 2 wrong usage
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
        // flushes, and tells of anything that was lost since the beginning
        boolean isLost = out.checkError();
        if (isLost) {
            err.println("standard output cannot be written: what was to be printed is lost");
        }
        err.flush();
        return isLost && exitCode == OK ? FAILED : exitCode;
    }

    /** Prints what may have been meant; all options are asked, those too that the help leaves out. */
    private static void printSuggestions(String[] args, PrintWriter err) {
        try {
            new SofasCommand().commandLine(true, args).parseArgs(SofasCommand.withoutHelpAll(args));
        } catch (CommandLine.ParameterException e) {
            CommandLine.UnmatchedArgumentException.printSuggestions(e, err);
        }
    }
}
