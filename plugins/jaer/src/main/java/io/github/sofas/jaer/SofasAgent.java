package io.github.sofas.jaer;

import java.lang.instrument.Instrumentation;
import java.lang.reflect.Field;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.logging.Logger;

/**
 * Java agent, for {@code -javaagent:sofas-jAER.jar}, that enters the filter in the list of jAER 3.3. That release loads
 * only classes of a list inside its own jar. It reads the list once, and the agent adds the filter's name to the names
 * that were read. Releases without such a list need no agent.
 */
public final class SofasAgent {
    private static final Logger LOG = Logger.getLogger("net.sf.jaer");
    private static final String LIST = "net.sf.jaer.util.JaerAllowedSubclasses";

    private SofasAgent() {
    }

    /** Enters the filter; the virtual machine calls this before jAER starts. */
    public static void premain(String arguments, Instrumentation instrumentation) {
        try {
            allow(Class.forName(LIST));
        } catch (ClassNotFoundException e) {
            LOG.fine("this jAER has no list of allowed filters");
        } catch (ReflectiveOperationException | LinkageError e) {
            LOG.warning("SOFAS cannot enter itself in jAER's list of filters (" + e
                + "); java -jar sofas-jAER.jar DIR starts jAER with it");
        }
    }

    private static void allow(Class<?> list) throws ReflectiveOperationException {
        Field cache = list.getDeclaredField("CACHE");
        cache.setAccessible(true);
        @SuppressWarnings("unchecked")
        Map<String, Set<String>> names = (Map<String, Set<String>>) cache.get(null);
        for (String kind : JaerFolder.KINDS) {
            Class<?> type = Class.forName(kind, false, list.getClassLoader());
            // reads the list into the cache; null if classes are not packed in a jar: then all are allowed
            Object read = list.getMethod("namesOrNullIfMissing", Class.class).invoke(null, type);
            if (read != null) {
                Set<String> more = new LinkedHashSet<>(names.get(kind));
                more.add(SofasFlow.class.getName());
                names.put(kind, more);
            }
        }
    }
}
