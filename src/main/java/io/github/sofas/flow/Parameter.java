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

    /** {@return the meaning in one line, without unit and range} */
    String value();

    /** {@return where it comes from: the paper, or why it is ours} */
    String origin();

    /** {@return the unit, empty for a plain number} */
    String unit() default "";

    /** {@return the smallest allowed value; unused for switches} */
    double min() default 0;

    /** {@return the largest allowed value; unused for switches} */
    double max() default 1;

    /** {@return the value in the preset {@code default}} */
    double defaults() default UNUSED;

    /** {@return the value in the preset {@code paper}} */
    double paper() default UNUSED;

    /** {@return another parameter that it must not be below, where the preset makes use of both; empty for none} */
    String atLeast() default "";

    /** {@return how many times as great as {@link #atLeast} it must be at least} */
    double times() default 1;

    /** What a group of parameters is about, in one or two words. */
    @Documented
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.RECORD_COMPONENT)
    @interface Group {
        /** {@return the words} */
        String value();
    }
}
