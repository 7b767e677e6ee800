package majic.figures;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/**
 * A TCP port in front of a rosbridge server, which passes everything on and records what clients subscribe to, and when
 * velocities arrive. It reads the frames of clients as RFC 6455 (section 5.2) defines them.
 */
final class RosTap implements AutoCloseable {
    private static final int MASKED = 0x80;
    private static final int OPCODE = 0x0F;
    private static final int TEXT = 1;
    private static final int LENGTH_16 = 126;
    private static final int LENGTH_64 = 127;
    private static final int MASK_BYTES = 4;
    private static final int LONGEST = 1 << 20;
    private static final int END_OF_HEADERS = 0x0D0A0D0A;

    private final ObjectMapper mapper = new ObjectMapper();
    private final ServerSocket port = new ServerSocket(0, 8, InetAddress.getLoopbackAddress());
    private final String host;
    private final int serverPort;
    private final List<JsonNode> subscriptions = new ArrayList<>();
    private final List<Velocity> velocities = new ArrayList<>();
    private final AtomicReference<JsonNode> velocityTopic = new AtomicReference<>(MissingNode.getInstance());
    private final AtomicLong bytesToClients = new AtomicLong();

    /**
     * A velocity for the robot.
     *
     * @param nanos when its last byte arrived, {@link System#nanoTime}
     * @param isZero whether it stops the robot
     */
    record Velocity(long nanos, boolean isZero) {}

    private interface Work {
        void run() throws IOException;
    }

    private RosTap(String host, int serverPort) throws IOException {
        this.host = host;
        this.serverPort = serverPort;
    }

    /** Opens a port in front of a server. */
    static RosTap of(String host, int serverPort) throws IOException {
        RosTap tap = new RosTap(host, serverPort);
        begin(() -> {
            while (true) {
                tap.connect(tap.port.accept());
            }
        });
        return tap;
    }

    int port() {
        return port.getLocalPort();
    }

    /** Returns the subscriptions of all clients so far, as they were sent. */
    List<JsonNode> subscriptions() {
        synchronized (subscriptions) {
            return List.copyOf(subscriptions);
        }
    }

    /** Returns the velocities so far, in the order of their arrival. */
    List<Velocity> velocities() {
        synchronized (velocities) {
            return List.copyOf(velocities);
        }
    }

    /** Returns the message by which a client advertised its velocities, with topic and type; missing if none did. */
    JsonNode velocityTopic() {
        return velocityTopic.get();
    }

    /** Returns how many bytes the server has sent to all clients. */
    long bytesToClients() {
        return bytesToClients.get();
    }

    @Override
    public void close() throws IOException {
        port.close();
    }

    private void connect(Socket client) throws IOException {
        Socket server = new Socket(host, serverPort);
        client.setTcpNoDelay(true);
        server.setTcpNoDelay(true);
        begin(() -> {
            try (server) {
                readClient(new Copied(client.getInputStream(), server.getOutputStream()));
            }
        });
        begin(() -> {
            try (client) {
                byte[] chunk = new byte[1 << 16];
                InputStream in = server.getInputStream();
                for (int count = in.read(chunk); count >= 0; count = in.read(chunk)) {
                    bytesToClients.addAndGet(count);
                    client.getOutputStream().write(chunk, 0, count);
                }
            }
        });
    }

    private void readClient(Copied bytes) throws IOException {
        DataInputStream in = new DataInputStream(new BufferedInputStream(bytes));
        int last = 0;
        while (last != END_OF_HEADERS) {
            last = last << Byte.SIZE | in.readUnsignedByte();
        }
        while (true) {
            int opcode = in.readUnsignedByte() & OPCODE;
            byte[] payload = payload(in);
            if (opcode == TEXT) {
                record(mapper.readTree(payload), bytes.lastReadNanos);
            }
        }
    }

    private static byte[] payload(DataInputStream in) throws IOException {
        int second = in.readUnsignedByte();
        long length = second & ~MASKED;
        if (length == LENGTH_16) {
            length = in.readUnsignedShort();
        } else if (length == LENGTH_64) {
            length = in.readLong();
        }
        if ((second & MASKED) == 0 || length > LONGEST) {
            throw new IOException("no frame of a client, or one of " + length + " bytes");
        }
        byte[] mask = in.readNBytes(MASK_BYTES);
        byte[] payload = in.readNBytes((int) length);
        for (int at = 0; at < payload.length; at++) {
            payload[at] ^= mask[at % MASK_BYTES];
        }
        return payload;
    }

    private void record(JsonNode message, long nanos) {
        String operation = message.path("op").asText();
        if (operation.equals("subscribe")) {
            synchronized (subscriptions) {
                subscriptions.add(message);
            }
        }
        if (operation.equals("advertise") && message.path("type").asText().contains("/Twist")) {
            velocityTopic.set(message);
        }
        JsonNode twist = message.path("msg").has("twist") ? message.path("msg").path("twist") : message.path("msg");
        if (operation.equals("publish") && twist.has("linear")) {
            boolean isZero = twist.path("linear").path("x").asDouble() == 0
                    && twist.path("angular").path("z").asDouble() == 0;
            synchronized (velocities) {
                velocities.add(new Velocity(nanos, isZero));
            }
        }
    }

    private static void begin(Work work) {
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } catch (IOException e) {
                        // one of the two ends was closed
                    }
                },
                "rosbridge tap");
        thread.setDaemon(true);
        thread.start();
    }

    /** Passes what is read on to the server. */
    private static final class Copied extends InputStream {
        private final InputStream in;
        private final OutputStream out;
        private long lastReadNanos;

        Copied(InputStream in, OutputStream out) {
            this.in = in;
            this.out = out;
        }

        @Override
        public int read() {
            throw new UnsupportedOperationException("only whole buffers are read");
        }

        @Override
        public int read(byte[] buffer, int from, int length) throws IOException {
            int count = in.read(buffer, from, length);
            lastReadNanos = System.nanoTime();
            if (count > 0) {
                out.write(buffer, from, count);
            }
            return count;
        }

        @Override
        public int available() throws IOException {
            return in.available();
        }
    }
}
