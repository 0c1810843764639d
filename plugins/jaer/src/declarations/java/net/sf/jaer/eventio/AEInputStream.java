package net.sf.jaer.eventio;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public abstract class AEInputStream {
    public static final String EVENT_REWOUND = "rewound";
    public static final String EVENT_REPOSITIONED = "respositioned";
}
