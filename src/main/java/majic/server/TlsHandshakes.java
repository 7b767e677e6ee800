package majic.server;

import java.io.IOException;
import java.nio.channels.SocketChannel;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.net.ssl.SSLEngine;

/**
 * Begins TLS on new connections, and spreads the computations of the handshakes over time: a flood of connections must
 * delay no line of a client that is admitted. Used by one thread.
 */
final class TlsHandshakes {
    /** Maximum number of computations a second; a handshake needs about two. */
    static final int STEPS_PER_SECOND = 100;

    private final ListenKey key;
    private final Consumer<String> alarm;
    private final Deque<Runnable> waiting = new ArrayDeque<>();
    private final Rate rate;
    private String reported = "";

    /**
     * Begins nothing yet.
     *
     * @param alarm receives a sentence, once, when a connection comes and the certificate has expired or will soon
     */
    TlsHandshakes(ListenKey key, LongSupplier nanos, Consumer<String> alarm) {
        this.key = key;
        this.alarm = alarm;
        rate = new Rate(STEPS_PER_SECOND, nanos);
    }

    /**
     * Prepares TLS on a connection.
     *
     * @param socket a connection in non-blocking mode
     * @param computed what to do after each computation, on the same thread: read again
     */
    Wire begin(SocketChannel socket, Runnable computed) throws IOException {
        warning().filter(text -> !text.equals(reported)).ifPresent(this::report);
        SSLEngine engine = key.context().createSSLEngine();
        engine.setUseClientMode(false);
        engine.setEnabledProtocols(new String[] {"TLSv1.3"});
        return new TlsWire(
                socket,
                engine,
                task -> waiting.add(() -> {
                    task.run();
                    computed.run();
                }));
    }

    /** Returns what the user should know about the certificate; empty if it is valid for long. */
    Optional<String> warning() {
        return key.warning(Instant.now());
    }

    private void report(String text) {
        reported = text;
        alarm.accept(text);
    }

    /** Runs at most one computation, a few milliseconds long. */
    void runNext() {
        if (!waiting.isEmpty() && rate.take()) {
            waiting.remove().run();
        }
    }
}
