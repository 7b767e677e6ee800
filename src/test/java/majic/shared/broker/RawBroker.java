package majic.shared.broker;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A broker for one client at a time, which accepts it and sends prepared packets after each of its subscriptions. Keeps
 * the types of the packets that it receives.
 */
final class RawBroker implements AutoCloseable {
    private static final int CONNECT = 1;
    private static final int PUBLISH = 3;
    private static final int SUBSCRIBE = 8;
    private static final int PINGREQ = 12;

    final List<Integer> received = new CopyOnWriteArrayList<>();
    private final List<byte[]> packets;
    private final int subscriptionAnswer;
    private final ServerSocket server;

    /**
     * @param subscriptionAnswer the reason code of SUBACK
     * @param packets sent after each subscription
     */
    RawBroker(int subscriptionAnswer, List<byte[]> packets) {
        this.subscriptionAnswer = subscriptionAnswer;
        this.packets = packets;
        try {
            server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Thread thread = new Thread(this::accept, "raw broker");
        thread.setDaemon(true);
        thread.start();
    }

    BrokerAddress address() {
        return BrokerAddress.parse("mqtt://127.0.0.1:" + server.getLocalPort() + "/lab");
    }

    /** How often a client has connected. */
    long connections() {
        return received.stream().filter(type -> type == CONNECT).count();
    }

    /** A packet PUBLISH of quality of service 1 with the content {@code {}}. */
    static byte[] publish(String topic, byte... properties) {
        return publish(topic.getBytes(StandardCharsets.UTF_8), properties);
    }

    static byte[] publish(byte[] topic, byte... properties) {
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        text(body, topic);
        body.writeBytes(new byte[] {0, 7, (byte) properties.length});
        body.writeBytes(properties);
        body.writeBytes(new byte[] {'{', '}'});
        return packet(PUBLISH << 4 | 2, body.toByteArray());
    }

    /** A property whose value is a text. */
    static byte[] property(int identifier, byte[] text) {
        ByteArrayOutputStream property = new ByteArrayOutputStream();
        property.write(identifier);
        text(property, text);
        return property.toByteArray();
    }

    private static void text(ByteArrayOutputStream to, byte[] text) {
        to.write(text.length >> 8);
        to.write(text.length);
        to.writeBytes(text);
    }

    private static byte[] packet(int first, byte[] body) {
        ByteArrayOutputStream packet = new ByteArrayOutputStream();
        packet.write(first);
        packet.write(body.length);
        packet.writeBytes(body);
        return packet.toByteArray();
    }

    private void accept() {
        while (!server.isClosed()) {
            try (Socket client = server.accept()) {
                serve(new DataInputStream(client.getInputStream()), client.getOutputStream());
            } catch (IOException e) {
                // The client or the test has ended; the next client is waited for.
            }
        }
    }

    private void serve(DataInputStream in, OutputStream out) throws IOException {
        while (true) {
            int type = in.readUnsignedByte() >> 4;
            int size = in.readUnsignedByte();
            byte[] body = in.readNBytes(size < 128 ? size : size - 128 + 128 * in.readUnsignedByte());
            received.add(type);
            switch (type) {
                case CONNECT -> out.write(packet(0x20, new byte[3]));
                case PINGREQ -> out.write(packet(0xD0, new byte[0]));
                case SUBSCRIBE -> {
                    out.write(packet(0x90, new byte[] {body[0], body[1], 0, (byte) subscriptionAnswer}));
                    ByteArrayOutputStream all = new ByteArrayOutputStream();
                    packets.forEach(all::writeBytes);
                    out.write(all.toByteArray());
                }
                default -> {}
            }
        }
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
