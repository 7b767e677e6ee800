package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import majicsim.net.LineCount;
import majicsim.net.Port;
import majicsim.pioneer.packet.Hex;
import majicsim.pioneer.packet.Packet;
import majicsim.pioneer.packet.PacketReader;
import majicsim.pioneer.packet.PacketWriter;

/**
 * A client of a {@link Stand} as a test sees it: it writes, lets lab time pass, and has then read all there was to
 * read.
 */
final class StandClient {
    private static final double STEP_SECONDS = 0.004;

    private final Stand stand;
    private final Port port;
    private final Wire wire;
    private final LongConsumer taken;
    private final PacketReader reader = new PacketReader();
    private final ArrayDeque<Packet> unread = new ArrayDeque<>();
    private long consumed;
    private long received;

    /**
     * A client that throws away what an earlier one has left unread, as every client does first. How much that is the
     * line says; what it has at hand says nothing, for the system may still be busy passing it on.
     */
    StandClient(Stand stand, Port port, Wire wire, long takenBefore, LongConsumer taken) throws IOException {
        this.stand = stand;
        this.port = port;
        this.wire = wire;
        this.taken = taken;
        LineCount before = awaitLine();
        consumed = before.consumed();
        received = before.written();
        wire.read((int) (received - takenBefore));
    }

    /** One write, dealt with by the robot when this returns. */
    void write(byte[] bytes) throws IOException {
        wire.write(bytes);
        consumed += bytes.length;
        Optional<LineCount> line = line();
        while (line.isPresent() && line.get().consumed() < consumed) {
            Thread.onSpinWait();
            line = line();
        }
        receive();
    }

    void write(String hex) throws IOException {
        write(Hex.bytes(hex));
    }

    /** A command with an int, or without any argument. */
    void command(int id, int... value) throws IOException {
        write(packet(id, value));
    }

    static byte[] packet(int id, int... value) {
        PacketWriter packet = new PacketWriter(id);
        for (int number : value) {
            packet.uint8(number < 0 ? 0x1B : 0x3B).uint16(Math.abs(number));
        }
        return packet.toBytes();
    }

    /** The next packet of the robot, if one comes within the time. */
    Optional<Packet> next(double withinSeconds) throws IOException {
        for (double left = withinSeconds; unread.isEmpty() && left > 0; left -= STEP_SECONDS) {
            pass(STEP_SECONDS);
        }
        return Optional.ofNullable(unread.poll());
    }

    /** The next packet of this type; others are passed over. */
    Packet await(int type, double withinSeconds) throws IOException {
        for (double left = withinSeconds; left > 0; left -= STEP_SECONDS) {
            for (Packet packet = unread.poll(); packet != null; packet = unread.poll()) {
                if (packet.id() == type) {
                    return packet;
                }
            }
            pass(STEP_SECONDS);
        }
        return fail("no packet of type " + Integer.toHexString(type) + " within " + withinSeconds + " s");
    }

    /** The next SIP. */
    SipView sip() throws IOException {
        for (Packet packet : during(0.1)) {
            if ((packet.id() & 0xF0) == 0x30) {
                return view(packet);
            }
        }
        return sip();
    }

    /** The SIP at the end of this time. */
    SipView sipAfter(double seconds) throws IOException {
        during(seconds - 0.1);
        return sip();
    }

    /** Everything the robot sends in this time. */
    List<Packet> during(double seconds) throws IOException {
        pass(seconds);
        List<Packet> packets = new ArrayList<>(unread);
        unread.clear();
        return packets;
    }

    Wire wire() {
        return wire;
    }

    /** Disconnects without CLOSE; when this returns, the robot's end has noticed what it can notice. */
    void vanish() throws IOException {
        receive();
        taken.accept(received);
        wire.vanish();
        while (wire.isNoticed() && line().isPresent()) {
            Thread.onSpinWait();
        }
    }

    /** The robot hangs up, at the latest now. */
    void awaitEnd() throws IOException {
        assertThat(wire.read(100_000)).hasSizeLessThan(100_000);
    }

    private void pass(double seconds) throws IOException {
        stand.step(seconds);
        receive();
    }

    private void receive() throws IOException {
        long written = line().map(LineCount::written).orElse(received);
        byte[] bytes = wire.read((int) (written - received));
        received = written;
        unread.addAll(reader.feed(bytes));
    }

    private static SipView view(Packet packet) {
        PacketWriter whole = new PacketWriter(packet.id());
        for (byte b : packet.data()) {
            whole.uint8(b);
        }
        return new SipView(whole.toBytes());
    }

    private Optional<LineCount> line() {
        return Stand.count(port, wire.key());
    }

    private LineCount awaitLine() {
        Optional<LineCount> line = line();
        while (line.isEmpty()) {
            Thread.onSpinWait();
            line = line();
        }
        return line.get();
    }
}
