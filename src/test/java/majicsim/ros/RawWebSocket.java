package majicsim.ros;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** A WebSocket client on a plain socket, written for tests from RFC 6455 alone; every read gives up after a minute. */
public final class RawWebSocket implements AutoCloseable {
    public static final int TEXT = 1;
    static final int BINARY = 2;
    static final int CLOSE = 8;
    static final int PING = 9;
    static final int PONG = 10;

    /** The example of RFC 6455, section 1.3. */
    static final String KEY = "dGhlIHNhbXBsZSBub25jZQ==";

    private static final int TIMEOUT_MS = 60_000;
    private static final int FINAL = 0x80;
    private static final int MASKED = 0x80;
    private static final byte[] MASK = {0x12, 0x34, 0x56, 0x78};

    /** A frame as it came. */
    record Received(int opcode, boolean isFinal, byte[] payload) {
        String text() {
            return new String(payload, StandardCharsets.UTF_8);
        }

        int closeCode() {
            return ByteBuffer.wrap(payload).getShort();
        }
    }

    private final Socket socket;
    private final DataInputStream input;
    private long sentBytes;

    RawWebSocket(String address) throws IOException {
        int colon = address.lastIndexOf(':');
        socket = new Socket(address.substring(0, colon), Integer.parseInt(address.substring(colon + 1)));
        socket.setSoTimeout(TIMEOUT_MS);
        socket.setTcpNoDelay(true);
        input = new DataInputStream(new BufferedInputStream(socket.getInputStream()));
    }

    /** Opens a connection and checks nothing. */
    static RawWebSocket open(String address) throws IOException {
        RawWebSocket opened = new RawWebSocket(address);
        opened.request("/");
        return opened;
    }

    /** A correct request for a connection. */
    public static byte[] handshake(String path) {
        return ("GET " + path + " HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                        + "Sec-WebSocket-Key: " + KEY + "\r\nSec-WebSocket-Version: 13\r\n\r\n")
                .getBytes(StandardCharsets.ISO_8859_1);
    }

    /** Sends a correct request; returns the head of the answer. */
    String request(String path) throws IOException {
        sendBytes(handshake(path));
        return readHead();
    }

    String readHead() throws IOException {
        ByteArrayOutputStream head = new ByteArrayOutputStream();
        while (!head.toString(StandardCharsets.ISO_8859_1).endsWith("\r\n\r\n")) {
            head.write(input.readUnsignedByte());
        }
        return head.toString(StandardCharsets.ISO_8859_1);
    }

    /** How much was sent, the request included. */
    long sentBytes() {
        return sentBytes;
    }

    void sendBytes(byte[] bytes) throws IOException {
        sentBytes += bytes.length;
        socket.getOutputStream().write(bytes);
    }

    void sendText(String text) throws IOException {
        sendBytes(frame(TEXT, true, text.getBytes(StandardCharsets.UTF_8)));
    }

    /** A masked frame, as a client must send it. */
    public static byte[] frame(int opcode, boolean isFinal, byte[] payload) {
        ByteBuffer frame = ByteBuffer.allocate(payload.length + 14);
        frame.put((byte) (opcode | (isFinal ? FINAL : 0)));
        if (payload.length < 126) {
            frame.put((byte) (MASKED | payload.length));
        } else if (payload.length <= 0xFFFF) {
            frame.put((byte) (MASKED | 126)).putShort((short) payload.length);
        } else {
            frame.put((byte) (MASKED | 127)).putLong(payload.length);
        }
        frame.put(MASK);
        for (int i = 0; i < payload.length; i++) {
            frame.put((byte) (payload[i] ^ MASK[i % MASK.length]));
        }
        byte[] bytes = new byte[frame.position()];
        frame.flip().get(bytes);
        return bytes;
    }

    /** Reads the next frame of any kind. */
    Received read() throws IOException {
        int first = input.readUnsignedByte();
        int second = input.readUnsignedByte();
        if ((second & MASKED) != 0) {
            throw new IOException("a server's frame must not be masked");
        }
        long length = switch (second) {
            case 126 -> input.readUnsignedShort();
            case 127 -> input.readLong();
            default -> second;
        };
        byte[] payload = new byte[(int) length];
        input.readFully(payload);
        return new Received(first & 0x0F, (first & FINAL) != 0, payload);
    }

    /** Whether the server has closed the connection; waits for it. */
    boolean isEnded() throws IOException {
        try {
            return input.read() < 0;
        } catch (EOFException e) {
            return true;
        }
    }

    /** Ends as a process that is killed. */
    void reset() throws IOException {
        socket.setSoLinger(true, 0);
        socket.close();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
