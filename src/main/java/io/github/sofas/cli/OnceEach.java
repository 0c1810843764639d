package io.github.sofas.cli;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

/**
 * Refuses an option that stands twice. Only one of two values would count, and nobody could see which. For options in
 * groups, the parser silently takes the last.
 */
final class OnceEach {
    private static final String END_OF_OPTIONS = "--";

    private OnceEach() {
    }

    /**
     * Checks the arguments as they were typed.
     *
     * @throws ParameterException at the first option that stands twice
     */
    static void check(ParseResult parsed) {
        ParseResult last = parsed;
        while (last.hasSubcommand()) {
            last = last.subcommand();
        }
        CommandSpec command = last.commandSpec();
        List<String> typed = parsed.originalArgs();
        Set<OptionSpec> seen = new HashSet<>();
        for (int i = 0; i < typed.size() && !typed.get(i).equals(END_OF_OPTIONS); i++) {
            String token = typed.get(i);
            int equals = token.indexOf('=');
            String name = equals > 0 && token.startsWith("--") ? token.substring(0, equals) : token;
            OptionSpec option = command.optionsMap().get(name);
            if (option == null) {
                continue;
            }
            if (!seen.add(option)) {
                throw new ParameterException(command.commandLine(), "option " + option.longestName()
                    + " must stand once but stands twice");
            }
            // skips the value, which may look like an option
            i += option.arity().max() > 0 && equals < 0 ? 1 : 0;
        }
    }
}
