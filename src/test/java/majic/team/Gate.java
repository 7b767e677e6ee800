package majic.team;

import java.lang.reflect.Proxy;

/** Blocks all threads that pass it while it is closed. Thread-safe. */
public final class Gate {
    private boolean closed;

    /** Returns a gate that is closed, for a test that opens it at its end. */
    public static Gate closed() {
        Gate gate = new Gate();
        gate.close();
        return gate;
    }

    public synchronized void close() {
        closed = true;
    }

    public synchronized void open() {
        closed = false;
        notifyAll();
    }

    public synchronized void pass() {
        try {
            while (closed) {
                wait();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns a listener each of whose methods passes the gate. */
    public <T> T blocked(Class<T> listener) {
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
