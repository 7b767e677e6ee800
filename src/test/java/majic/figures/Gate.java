package majic.figures;

import java.lang.reflect.Proxy;

/** Blocks all threads that pass it while it is closed. Thread-safe. */
final class Gate {
    private boolean closed;

    synchronized void close() {
        closed = true;
    }

    synchronized void open() {
        closed = false;
        notifyAll();
    }

    synchronized void pass() {
        try {
            while (closed) {
                wait();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns a listener each of whose methods passes the gate. */
    <T> T blocked(Class<T> listener) {
        return listener.cast(Proxy.newProxyInstance(
                listener.getClassLoader(),
                new Class<?>[] {listener},
                (proxy, method, arguments) -> switch (method.getName()) {
                    case "equals" -> proxy == arguments[0];
                    case "hashCode" -> System.identityHashCode(proxy);
                    case "toString" -> "a listener that blocks";
                    default -> {
                        pass();
                        yield null;
                    }
                }));
    }
}
