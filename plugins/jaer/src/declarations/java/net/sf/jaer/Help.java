package net.sf.jaer;

import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
@Retention(RetentionPolicy.RUNTIME)
public @interface Help {
    String value();
}
