package io.github.sofas.flow;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The declaration of a parameter in {@link SofasParameters}: what it means, which values it takes, and which values it
 * has in the presets. Checks, presets, command-line options, config files, help and the controls of the viewer all
 * follow from it, by {@link ParameterHandle}.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Parameter {
    /** As a preset's value: the switch is on. */
    double ON = 1;
    /** As a preset's value: the switch is off. */
    double OFF = 0;
    /** As a preset's value: the preset makes no use of the parameter. */
    double UNUSED = Double.NaN;

    /** {@return the meaning in one line, without unit and range} */
    String value();

    /** {@return the origin: where in the paper the parameter is, or why it is ours} */
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

    /** {@return another parameter that this one must not be below, if the preset uses both; empty for none} */
    String atLeast() default "";

    /** {@return the least ratio of this parameter to {@link #atLeast}} */
    double times() default 1;

    /** The subject of a group of parameters, in one or two words. */
    @Documented
    @Retention(RetentionPolicy.RUNTIME)
    @Target(ElementType.RECORD_COMPONENT)
    @interface Group {
        /** {@return the subject} */
        String value();
    }
}
