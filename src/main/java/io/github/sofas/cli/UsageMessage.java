package io.github.sofas.cli;

import java.util.Set;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;

/** Messages about wrong arguments in the form that all messages have: the option, the rule, the value. */
final class UsageMessage {
    private static final Set<Class<?>> WHOLE = Set.of(int.class, Integer.class, long.class, Long.class);
    private static final Set<Class<?>> REAL = Set.of(double.class, Double.class);

    private UsageMessage() {
    }

    /** The message of an exception; in our words if a value has the wrong type. */
    static String of(ParameterException thrown) {
        ArgSpec argument = thrown.getArgSpec();
        String rule = thrown.getCause() instanceof TypeConversionException && argument instanceof OptionSpec
            ? rule(argument) : null;
        return rule == null ? thrown.getMessage()
            : ((OptionSpec) argument).longestName() + " must be " + rule + " but was \"" + thrown.getValue() + "\"";
    }

    /** What the values of an option must be; null if there is no word for it. */
    private static String rule(ArgSpec option) {
        // for a list, the type of its elements
        Class<?>[] types = option.auxiliaryTypes();
        if (option.completionCandidates() != null) {
            return "one of " + String.join(", ", option.completionCandidates());
        }
        return WHOLE.contains(types[0]) ? "a whole number" : REAL.contains(types[0]) ? "a number" : null;
    }
}
