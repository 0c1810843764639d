package io.github.sofas.flow;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * What a component of {@link SofasParameters} means and which values it takes. The record's check, the command line's
 * options and the viewer's sliders all read it here.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Parameter {
    /** Meaning in one line, without unit and range. */
    String value();

    /** Unit, empty for a plain number. */
    String unit() default "";

    /** Smallest allowed value; unused for booleans. */
    double min() default 0;

    /** Largest allowed value; unused for booleans. */
    double max() default 1;
}
