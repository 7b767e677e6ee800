package majicsim.pioneer;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.LineCount;
import majicsim.net.Port;
import majicsim.net.PtyPort;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Noise;
import majicsim.world.Pose;

/** A Pioneer behind a real TCP port and a real pseudo-terminal, in a lab that the test steps. */
final class Stand implements AutoCloseable {
    final Rig rig;
    private final ReentrantLock lock = new ReentrantLock(true);
    private final TcpPort tcp;
    private final Optional<PtyPort> pty;
    private long nanos;

    /** How much of what the robot has ever sent over its serial plug a client has taken there. */
    private long takenFromPlug;

    Stand(Noise noise) throws IOException {
        rig = new Rig(new Pose(0, 0, 0), noise, PioneerRobot.STANDARD_MODEL);
        rig.robot.disconnected(rig.line);
        Faults faults = new Faults(Noise.exact());
        tcp = TcpPort.open(0, Clients.ONE, new Wiring(lock, rig.robot, faults));
        pty = PtyPort.open(new Wiring(lock, rig.robot.serialPort(), faults));
    }

    boolean hasSerialPort() {
        return pty.isPresent();
    }

    StandClient tcpClient() throws IOException {
        return new StandClient(this, tcp, new TcpWire(tcp.number()), 0, taken -> {});
    }

    /** One that the robot may turn away. */
    Wire secondClient() throws IOException {
        return new TcpWire(tcp.number());
    }

    StandClient serialClient() throws IOException {
        PtyPort port = pty.orElseThrow();
        return new StandClient(
                this, port, new SerialClientWire(port.address()), takenFromPlug, taken -> takenFromPlug = taken);
    }

    /** Lets the lab go on; all that the robot sends in that time is on its way when this returns. */
    void step(double seconds) {
        lock.lock();
        try {
            rig.step(seconds);
            nanos += Math.round(seconds * 1e9);
            tcp.step(nanos);
            pty.ifPresent(port -> port.step(nanos));
        } finally {
            lock.unlock();
        }
    }

    /** How far the client's line has got; empty once it is gone. */
    static Optional<LineCount> count(Port port, String key) {
        return port.lines().stream().filter(line -> line.peer().equals(key)).findFirst();
    }

    @Override
    public void close() {
        tcp.close();
        pty.ifPresent(PtyPort::close);
    }
}
