package io.github.sofas.cli;

import java.io.PrintWriter;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The command without a subcommand, and the options that all share. */
@Command(name = "sofas", mixinStandardHelpOptions = true, scope = ScopeType.INHERIT, versionProvider = Version.class,
    synopsisSubcommandLabel = "COMMAND",
    description = "Optical flow and segment of every event of event-camera recordings.",
    subcommands = {RunCommand.class, RenderCommand.class, LiveCommand.class, InfoCommand.class, EvaluateCommand.class,
        SimulateCommand.class, ExperimentsCommand.class, CompareCommand.class, BenchCommand.class, HelpCommand.class,
        AutoComplete.GenerateCompletion.class})
final class SofasCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    @Option(names = "--verbose", scope = ScopeType.INHERIT,
        description = "Show where in the program an unexpected error arose.")
    private boolean verbose;

    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "a command is missing");
    }

    /** Says in one line that a fault of the program itself was met; with {@code --verbose}, where. */
    void printUnexpected(PrintWriter err, String place, Throwable exception) {
        err.println(place + "unexpected error: " + exception + (verbose ? "" : " (--verbose shows where)"));
        if (verbose) {
            exception.printStackTrace(err);
        }
    }
}
