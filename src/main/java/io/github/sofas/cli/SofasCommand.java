package io.github.sofas.cli;

import io.github.sofas.batch.Cluster;
import java.io.PrintWriter;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The command without a subcommand, and the options that all commands share. This class assembles the command line. */
@Command(name = "sofas", mixinStandardHelpOptions = true, scope = ScopeType.INHERIT, versionProvider = Version.class,
    synopsisSubcommandLabel = "COMMAND",
    description = "Optical flow and segmentation of event-camera recordings, per event.")
final class SofasCommand implements Callable<Integer> {
    /** Commands in the order of the help text. */
    private static final List<Class<?>> COMMANDS = List.of(RunCommand.class, BatchCommand.class, RenderCommand.class,
        LiveCommand.class, InfoCommand.class, ConvertCommand.class, EvaluateCommand.class, SimulateCommand.class,
        ExperimentsCommand.class, CompareCommand.class, BenchCommand.class);
    /** Commands about commands, which need all of the others. */
    private static final List<Class<?>> ABOUT_COMMANDS = List.of(HelpCommand.class,
        AutoComplete.GenerateCompletion.class);
    /** Commands that have the algorithm's parameters as options. */
    private static final Set<Class<?>> WITH_PARAMETERS = Set.of(RunCommand.class, BatchCommand.class,
        RenderCommand.class, LiveCommand.class, EvaluateCommand.class, ExperimentsCommand.class, BenchCommand.class);

    private static final String HELP_ALL = "--help-all";
    /** With these arguments, help and completion show the algorithm's parameters, too. */
    private static final Set<String> SHOW_PARAMETERS = Set.of(HELP_ALL, "generate-completion");

    /** The cluster on which batches run; null if there is none. */
    private final Cluster cluster;

    @Spec
    private CommandSpec spec;

    /** Never parsed: {@link #withoutHelpAll} replaces it by {@code --help}, the only possible help option. */
    @Option(names = HELP_ALL, scope = ScopeType.INHERIT,
        description = "Show this help message with all parameters of the algorithm and exit.")
    private boolean helpAll;

    @Option(names = "--verbose", scope = ScopeType.INHERIT,
        description = "Print the stack trace of an unexpected error.")
    private boolean verbose;

    SofasCommand() {
        this(null);
    }

    /** The same with a cluster for batches. */
    SofasCommand(Cluster cluster) {
        this.cluster = cluster;
    }

    /** The cluster on which batches run; null if there is none. */
    Cluster cluster() {
        return cluster;
    }

    /**
     * Returns the command line with the command that is asked for, or with all if none is named. Preparing a command
     * takes several times as long as reading its arguments.
     */
    CommandLine commandLine(String... arguments) {
        return commandLine(Arrays.stream(arguments).anyMatch(SHOW_PARAMETERS::contains), arguments);
    }

    /** The same with the algorithm's parameters shown or not, whatever the arguments ask for. */
    CommandLine commandLine(boolean showsParameters, String... arguments) {
        CommandLine line = new CommandLine(this);
        List<Class<?>> asked = COMMANDS.stream()
            .filter(each -> arguments.length > 0 && name(each).equals(arguments[0]))
            .collect(Collectors.toList());
        for (Class<?> each : asked.isEmpty() ? COMMANDS : asked) {
            line.addSubcommand(each);
            if (WITH_PARAMETERS.contains(each)) {
                ParameterOptions.addTo(line.getSubcommands().get(name(each)).getCommandSpec(), showsParameters);
            }
        }
        if (asked.isEmpty()) {
            ABOUT_COMMANDS.forEach(line::addSubcommand);
        }
        line.setCaseInsensitiveEnumValuesAllowed(true);
        // A recording may be named @list, and is not a list of arguments.
        line.setExpandAtFiles(false);
        return line;
    }

    /** The arguments as they are to be parsed, after {@link #commandLine} has looked at them. */
    static String[] withoutHelpAll(String... arguments) {
        return Arrays.stream(arguments).map(each -> each.equals(HELP_ALL) ? "--help" : each).toArray(String[]::new);
    }

    private static String name(Class<?> command) {
        return command.getAnnotation(Command.class).name();
    }

    @Override
    public Integer call() {
        spec.commandLine().usage(spec.commandLine().getErr());
        return Main.USAGE;
    }

    /** Reports in one line a fault of the program itself; with {@code --verbose}, also where it occurred. */
    void printUnexpected(PrintWriter err, String place, Throwable exception) {
        err.println(place + "unexpected error: " + exception + (verbose ? "" : " (--verbose shows where)"));
        if (verbose) {
            exception.printStackTrace(err);
        }
    }
}
