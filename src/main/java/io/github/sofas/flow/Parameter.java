package io.github.sofas.flow;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * All there is to a parameter, at its declaration in {@link SofasParameters}: what it means, which values it takes, and
 * which it has in the presets. Checks, presets, the command line's options, config files, help and the viewer's
 * controls all follow from it, by {@link ParameterHandle}.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Parameter {
    /** A switch that is on, as a preset's value. */
    double ON = 1;
    /** A switch that is off, as a preset's value. */
    double OFF = 0;
    /** The value of a preset that makes no use of the parameter. */
    double UNUSED = Double.NaN;

    /** Meaning in one line, without unit and range. */
    String value();

    /** Where it comes from: the paper, or why it is ours. */
    String origin();

    /** Unit, empty for a plain number. */
    String unit() default "";

    /** Smallest allowed value; unused for switches. */
    double min() default 0;

    /** Largest allowed value; unused for switches. */
    double max() default 1;

    /** Value in the preset {@code default}. */
    double defaults() default UNUSED;

    /** Value in the preset {@code paper}. */
    double paper() default UNUSED;

    /** Another parameter that it must not be below, where the preset makes use of both; empty for none. */
    String atLeast() default "";

    /** How many times as great as {@link #atLeast} it must be at least. */
    double times() default 1;

    /** What a group of parameters is about, in one or two words. */
    @Documented
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.RECORD_COMPONENT)
    @interface Group {
        /** The words. */
        String value();
    }
}
