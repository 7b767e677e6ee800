package majic.shared.broker;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/** A port that answers the first bytes of each client with bytes of its own, or closes the connection. */
final class ScriptedServer implements AutoCloseable {
    private final ServerSocket server;
    private final byte @Nullable [] answer;
    /** Java closes a socket that nothing refers to. */
    private final List<Socket> open = new CopyOnWriteArrayList<>();

    /** Answers with bytes, after which the connection stays open; closes the connection if there are none. */
    ScriptedServer(byte @Nullable [] answer) {
        this.answer = answer;
        try {
            server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Thread thread = new Thread(this::accept, "scripted server");
        thread.setDaemon(true);
        thread.start();
    }

    int port() {
        return server.getLocalPort();
    }

    private void accept() {
        while (!server.isClosed()) {
            try {
                answer(server.accept());
            } catch (IOException e) {
                // The client or the test has ended; the next client is waited for.
            }
        }
    }

    private void answer(Socket client) throws IOException {
        byte[] bytes = new byte[1000];
        if (client.getInputStream().read(bytes) < 0) {
            client.close();
        } else if (answer == null) {
            client.close();
        } else {
            open.add(client);
            client.getOutputStream().write(answer);
        }
    }

    @Override
    public void close() {
        try {
            server.close();
            for (Socket client : open) {
                client.close();
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
