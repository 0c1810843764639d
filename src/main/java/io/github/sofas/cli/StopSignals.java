package io.github.sofas.cli;

import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Handles Ctrl-C and the signal that ends services as a request to finish. The second signal ends the program at once,
 * as all others do.
 *
 * <p>The only supported way in Java is a shutdown hook, which can neither finish in order nor set the exit code. The
 * class {@code sun.misc.Signal} is in every Java, but compilers warn about it. Therefore, it is called by reflection.
 */
final class StopSignals implements AutoCloseable {
    private static final String[] NAMES = {"INT", "TERM"};
    private static final int KILLED = 130;

    private final Map<Object, Object> handlersBefore = new LinkedHashMap<>();

    private StopSignals() {
    }

    /**
     * Handles the signals until the result is closed.
     *
     * @param finish called once, on a thread of its own
     */
    static StopSignals handle(Runnable finish) {
        StopSignals signals = new StopSignals();
        AtomicBoolean finishing = new AtomicBoolean();
        Runnable once = () -> {
            if (finishing.getAndSet(true)) {
                System.exit(KILLED);
            }
            finish.run();
        };
        for (String name : NAMES) {
            signals.install(name, once);
        }
        return signals;
    }

    private void install(String name, Runnable action) {
        try {
            Class<?> handlerType = Class.forName("sun.misc.SignalHandler");
            Object handler = Proxy.newProxyInstance(handlerType.getClassLoader(), new Class<?>[] {handlerType},
                (proxy, method, arguments) -> {
                    if (method.getDeclaringClass() == handlerType) {
                        action.run();
                        return null;
                    }
                    return switch (method.getName()) {
                        case "hashCode" -> System.identityHashCode(proxy);
                        case "equals" -> proxy == arguments[0];
                        default -> name;
                    };
                });
            Object signal = Class.forName("sun.misc.Signal").getConstructor(String.class).newInstance(name);
            handlersBefore.put(signal, handle(signal, handler));
        } catch (ReflectiveOperationException e) {
            // A Java that keeps its signals to itself (-Xrs): they end the program, and unfinished results are deleted.
            return;
        }
    }

    private static Object handle(Object signal, Object handler) throws ReflectiveOperationException {
        return signal.getClass().getMethod("handle", signal.getClass(), Class.forName("sun.misc.SignalHandler"))
            .invoke(null, signal, handler);
    }

    /** Restores the handlers that were there before. */
    @Override
    public void close() {
        handlersBefore.forEach((signal, handler) -> {
            try {
                handle(signal, handler);
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException("a handler that was there can be set again", e);
            }
        });
    }
}
