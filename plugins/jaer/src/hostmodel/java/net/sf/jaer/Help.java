package net.sf.jaer;

import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;

/** As much of the class of that name in jAER as the tests of the filter need. */
@Retention(RetentionPolicy.RUNTIME)
public @interface Help {
    String value();
}
