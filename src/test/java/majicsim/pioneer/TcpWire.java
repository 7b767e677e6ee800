package majicsim.pioneer;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;

/** A client over TCP. */
final class TcpWire implements Wire {
    private static final int TIMEOUT_MS = 60_000;

    private final Socket socket;

    TcpWire(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setTcpNoDelay(true);
        socket.setSoTimeout(TIMEOUT_MS);
    }

    @Override
    public String key() {
        return "127.0.0.1:" + socket.getLocalPort();
    }

    @Override
    public void write(byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
    }

    @Override
    public byte[] read(int count) throws IOException {
        return socket.getInputStream().readNBytes(count);
    }

    @Override
    public void vanish() throws IOException {
        socket.close();
    }

    @Override
    public boolean isNoticed() {
        return true;
    }
}
