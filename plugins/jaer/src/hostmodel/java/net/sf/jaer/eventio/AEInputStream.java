package net.sf.jaer.eventio;

/** As much of the class of that name in jAER as the tests of the filter need. */
public abstract class AEInputStream {
    public static final String EVENT_REWOUND = "rewound";
    public static final String EVENT_REPOSITIONED = "respositioned";
}
