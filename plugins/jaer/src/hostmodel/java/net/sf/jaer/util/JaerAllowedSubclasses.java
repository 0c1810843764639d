package net.sf.jaer.util;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** As much of the class of that name in jAER as the tests of the agent need. */
public final class JaerAllowedSubclasses {
    private static final Map<String, Set<String>> CACHE = new ConcurrentHashMap<>();

    private JaerAllowedSubclasses() {
    }

    public static Set<String> namesOrNullIfMissing(Class<?> superType) {
        return CACHE.computeIfAbsent(superType.getName(), name -> Set.of("net.sf.jaer.of." + superType.getSimpleName()));
    }
}
