package io.github.sofas.cli;

import java.util.Set;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;

/** What is wrong with an argument, said as everywhere: the option, the rule, the value. */
final class UsageMessage {
    private static final Set<Class<?>> WHOLE = Set.of(int.class, Integer.class, long.class, Long.class);
    private static final Set<Class<?>> REAL = Set.of(double.class, Double.class);

    private UsageMessage() {
    }

    /** The message of what was thrown; of a value of the wrong type, in our words. */
    static String of(ParameterException thrown) {
        ArgSpec argument = thrown.getArgSpec();
        String rule = thrown.getCause() instanceof TypeConversionException && argument instanceof OptionSpec
            ? rule(argument) : null;
        return rule == null ? thrown.getMessage()
            : ((OptionSpec) argument).longestName() + " must be " + rule + " but was \"" + thrown.getValue() + "\"";
    }

    /** What values of an option must be; null where there is no word for it. */
    private static String rule(ArgSpec option) {
        // of a list, that of what is in it
        Class<?>[] types = option.auxiliaryTypes();
        if (option.completionCandidates() != null) {
            return "one of " + String.join(", ", option.completionCandidates());
        }
        return WHOLE.contains(types[0]) ? "a whole number" : REAL.contains(types[0]) ? "a number" : null;
    }
}
