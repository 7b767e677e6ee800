package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Noise;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the vendor's client sends in a session (ARCOS sheet 13.2), over a real socket; the lab is stepped by the test. */
@Timeout(20)
class AriaSessionTest {
    private static final int SOCKET_TIMEOUT_MS = 5000;

    private final Rig rig = Rig.silent();
    private final ReentrantLock lock = new ReentrantLock(true);
    private TcpPort port;
    /** The vendor's client never closes its socket by itself, so a session may leave one behind. */
    private final List<Socket> sockets = new ArrayList<>();

    private DataInputStream in;

    @BeforeEach
    void listen() throws IOException {
        rig.robot.disconnected(rig.line);
        port = TcpPort.open(0, Clients.ONE, new Wiring(lock, rig.robot, new Faults(Noise.exact())));
        connect();
    }

    @AfterEach
    void close() throws IOException {
        for (Socket socket : sockets) {
            socket.close();
        }
        port.close();
    }

    @Test
    void connectsDrivesTurnsAndClosesAgainAndAgainOnTheSamePort() throws IOException {
        driveAndClose();
        connect();
        driveAndClose();
        assertThat(rig.pose().headingDeg()).isCloseTo(180, within(0.5));
    }

    @Test
    void aSecondClientIsTurnedAwayAndTheFirstDrivesOn() throws IOException {
        shakeHands();
        try (Socket second = new Socket(InetAddress.getLoopbackAddress(), port.number())) {
            second.setSoTimeout(SOCKET_TIMEOUT_MS);
            assertThat(second.getInputStream().read()).isEqualTo(-1);
        }
        send("FA FB 06 04 3B 01 00 05 3B");
        assertThat(nextSip().hasMotors()).isTrue();
    }

    @Test
    void aClientThatComesRightAfterCloseIsServed() throws IOException {
        for (int i = 0; i < 20; i++) {
            shakeHands();
            send("FA FB 03 02 00 02");
            assertThat(in.read()).isEqualTo(-1);
            connect();
        }
        shakeHands();
        assertThat(nextSip().type()).isEqualTo(0x32);
    }

    private void driveAndClose() throws IOException {
        shakeHands();
        send("FA FB 06 12 3B 01 00 13 3B");
        assertThat(nextPacket()[3]).isEqualTo((byte) 0x20);
        send("FA FB 06 3E 3B 01 00 3F 3B");
        send("FA FB 06 06 3B B8 0B BE 46 FA FB 06 05 3B 2C 01 31 3C FA FB 06 05 1B 2C 01 31 1C"
                + "FA FB 06 0A 3B 96 00 A0 3B FA FB 06 17 3B 64 00 7B 3B FA FB 06 17 1B 64 00 7B 1B FA FB 03 00 00 00");
        assertThat(nextSip().hasMotors()).isFalse();
        send("FA FB 06 04 3B 01 00 05 3B FA FB 06 0B 3B FA 00 05 3B");
        assertThat(drive(1.5).left()).isEqualTo(250);
        send("FA FB 06 0B 3B 00 00 0B 3B FA FB 06 15 3B 00 00 15 3B");
        assertThat(drive(1).left()).isZero();
        send("FA FB 06 0C 3B 5A 00 66 3B");
        assertThat(drive(1.9).headingDeg()).isCloseTo(90, within(0.2));
        send("FA FB 06 04 3B 00 00 04 3B");
        assertThat(nextSip().hasMotors()).isFalse();
        send("FA FB 06 02 3B 01 00 03 3B");
        assertThat(in.read()).isEqualTo(-1);
    }

    private void connect() throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port.number());
        sockets.add(socket);
        socket.setSoTimeout(SOCKET_TIMEOUT_MS);
        socket.setTcpNoDelay(true);
        in = new DataInputStream(socket.getInputStream());
    }

    private void shakeHands() throws IOException {
        for (String sync : new String[] {"FA FB 03 00 00 00", "FA FB 03 01 00 01"}) {
            send(sync);
            assertThat(nextPacket()).isEqualTo(Hex.bytes(sync));
        }
        send("FA FB 03 02 00 02");
        assertThat(nextPacket()[3]).isEqualTo((byte) 2);
        send("FA FB 06 01 3B 01 00 02 3B");
    }

    private void send(String hex) throws IOException {
        sockets.get(sockets.size() - 1).getOutputStream().write(Hex.bytes(hex));
    }

    private byte[] nextPacket() throws IOException {
        byte[] head = in.readNBytes(3);
        return Hex.concat(head, in.readNBytes(head[2] & 0xFF));
    }

    /** Lets time pass and returns its last SIP. */
    private SipView drive(double seconds) throws IOException {
        SipView last = nextSip();
        for (int i = 1; i < Math.round(seconds * 10); i++) {
            last = nextSip();
        }
        return last;
    }

    /** A CONFIG answer shows that the robot has handled all that was sent; then a cycle passes. */
    private SipView nextSip() throws IOException {
        send("FA FB 03 12 00 12");
        byte[] packet = nextPacket();
        while (packet[3] != 0x20) {
            packet = nextPacket();
        }
        step();
        while (!SipView.isSip(packet)) {
            packet = nextPacket();
        }
        return new SipView(packet);
    }

    private void step() {
        lock.lock();
        try {
            rig.step(0.1);
        } finally {
            lock.unlock();
        }
    }
}
