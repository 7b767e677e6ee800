package majicsim.net;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** A plain TCP client for tests; every read gives up after a minute. */
public final class Client implements AutoCloseable {
    private static final int TIMEOUT_MS = 60_000;

    private final Socket socket;

    public Client(String address) throws IOException {
        int colon = address.lastIndexOf(':');
        socket = new Socket(address.substring(0, colon), Integer.parseInt(address.substring(colon + 1)));
        socket.setSoTimeout(TIMEOUT_MS);
        socket.setTcpNoDelay(true);
    }

    /** What the robot's end calls this client. */
    public String key() {
        return "127.0.0.1:" + socket.getLocalPort();
    }

    public void send(String latin1) throws IOException {
        socket.getOutputStream().write(latin1.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Reads exactly so many characters. */
    public String read(int count) throws IOException {
        return new String(socket.getInputStream().readNBytes(count), StandardCharsets.ISO_8859_1);
    }

    /** Reads until the other end closes. */
    public String readAll() throws IOException {
        return new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
    }

    public int available() throws IOException {
        return socket.getInputStream().available();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
