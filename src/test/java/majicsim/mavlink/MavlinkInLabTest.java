package majicsim.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToLongFunction;
import majicsim.Lab;
import majicsim.LabOptions;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.FrameReader;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import majicsim.net.LineCount;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** MAVLink vehicles in the lab, over real sockets. */
@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class MavlinkInLabTest {
    private static final int LARGEST = 65_536;
    private static final int STEPS_A_SECOND = 250;

    @AutoClose
    private final DatagramSocket station = new DatagramSocket(0, InetAddress.getLoopbackAddress());

    private final Map<SocketAddress, FrameReader> readers = new HashMap<>();
    private final Map<Integer, SocketAddress> peers = new HashMap<>();
    private final List<Frame> frames = new ArrayList<>();
    private long receivedBytes;

    MavlinkInLabTest() throws IOException {}

    private Lab lab(String models) throws IOException {
        return Lab.open(LabOptions.exactOnFreePorts()
                .withMavlink(MavlinkOptions.parse(models.replace("UDP", "udp=" + station.getLocalPort()))));
    }

    private static void steps(Lab lab, int count) {
        for (int i = 0; i < count; i++) {
            lab.step();
        }
    }

    /** Reads all datagrams that have been sent, as many bytes as the lab has counted. */
    private void read(Lab lab) throws IOException {
        while (receivedBytes < total(lab, LineCount::written)) {
            DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
            station.receive(packet);
            receivedBytes += packet.getLength();
            byte[] bytes = Arrays.copyOf(packet.getData(), packet.getLength());
            FrameReader reader = readers.computeIfAbsent(packet.getSocketAddress(), peer -> new FrameReader());
            for (Frame frame : reader.feed(bytes)) {
                peers.put(frame.system(), packet.getSocketAddress());
                frames.add(frame);
            }
        }
        assertThat(readers.values())
                .allSatisfy(reader -> assertThat(reader.damaged()).isZero());
    }

    /** Sends a message and waits until the vehicle has taken it. */
    private void send(Lab lab, int system, Message message) throws IOException {
        byte[] bytes = new Frame(2, 0, 255, 190, message).toBytes();
        long wanted = total(lab, LineCount::consumed) + bytes.length;
        station.send(new DatagramPacket(bytes, bytes.length, peers.get(system)));
        while (total(lab, LineCount::consumed) < wanted) {
            Thread.onSpinWait();
        }
    }

    private long total(Lab lab, ToLongFunction<LineCount> count) {
        String peer = "127.0.0.1:" + station.getLocalPort();
        return lab.lines().stream()
                .filter(line -> line.peer().equals(peer))
                .mapToLong(count)
                .sum();
    }

    private static Message command(int system, int number, double param1, double param2) {
        return new Message(MessageType.COMMAND_LONG)
                .with("command", number)
                .with("target_system", system)
                .with("param1", param1)
                .with("param2", param2);
    }

    @Test
    void severalVehiclesSendToOneGroundStationAndObeyApart() throws IOException {
        try (Lab lab = lab("rover+ready+UDP,rover+ready+UDP")) {
            steps(lab, STEPS_A_SECOND);
            read(lab);
            assertThat(peers).containsOnlyKeys(1, 2);
            send(lab, 2, command(2, 176, 1, 15));
            send(lab, 1, command(2, 176, 1, 15));
            steps(lab, STEPS_A_SECOND);
            lab.besideMavlink("mavlink", one -> assertThat(one.mode()).isZero());
            lab.besideMavlink("mavlink2", two -> assertThat(two.mode()).isEqualTo(15));
            frames.clear();
            read(lab);
            assertThat(frames)
                    .filteredOn(frame -> frame.message().type() == MessageType.COMMAND_ACK)
                    .singleElement()
                    .satisfies(ack -> assertThat(ack.system()).isEqualTo(2));
        }
    }

    @Test
    void datagramsAreDelayedAndLostOnRequest() throws IOException {
        try (Lab lab = lab("rover+ready+UDP")) {
            lab.faults("mavlink").delay(400);
            steps(lab, 50);
            read(lab);
            assertThat(frames).isEmpty();
            steps(lab, 100);
            read(lab);
            assertThat(frames).isNotEmpty();
            lab.faults("mavlink").none();
            steps(lab, 200);
            read(lab);
            frames.clear();
            lab.faults("mavlink").lose(1);
            steps(lab, STEPS_A_SECOND);
            send(lab, 1, command(1, 176, 1, 15));
            read(lab);
            assertThat(frames).isEmpty();
            lab.besideMavlink("mavlink", one -> assertThat(one.mode()).isZero());
        }
    }

    @Test
    void theConsoleBeginsWithTextAndTakesOneClient() throws IOException {
        try (Lab lab = lab("rover+ready");
                Socket first = connect(lab)) {
            byte[] text = first.getInputStream().readNBytes(16);
            assertThat(new String(text, StandardCharsets.US_ASCII)).startsWith("\n\nInit ArduRover");
            try (Socket second = connect(lab)) {
                assertThat(second.getInputStream().read()).isEqualTo(-1);
            }
            steps(lab, STEPS_A_SECOND);
            assertThat(new FrameReader().feed(first.getInputStream().readNBytes(200)))
                    .anySatisfy(frame -> assertThat(frame.message().type()).isEqualTo(MessageType.HEARTBEAT));
        }
    }

    private static Socket connect(Lab lab) throws IOException {
        String[] address = lab.addresses().get("mavlink").split(":");
        Socket socket = new Socket();
        socket.connect(new InetSocketAddress(address[0], Integer.parseInt(address[1])));
        return socket;
    }

    @Test
    void theVehiclesStandBesideTheUsualRobots() throws IOException {
        try (Lab lab = lab("rover,copter+UDP")) {
            assertThat(lab.truePoses().keySet()).containsExactly("aibo", "pioneer", "hemisson", "mavlink", "mavlink2");
            assertThat(lab.addresses()).containsKeys("mavlink", "mavlink2", "mavlink2-udp");
            assertThatThrownBy(() -> lab.besideMavlink("aibo", one -> {})).hasMessage("aibo is no MAVLink vehicle");
        }
    }

    @Test
    void aSecondVehicleListensTenPortsAboveTheFirst() throws IOException {
        try (Lab lab = Lab.open(LabOptions.standard().withMavlink(MavlinkOptions.parse("rover,rover")))) {
            assertThat(lab.addresses().get("mavlink")).startsWith("127.0.0.1:");
            assertThat(lab.addresses().get("mavlink2"))
                    .isNotEqualTo(lab.addresses().get("mavlink"));
        }
    }
}
