package majicsim.hemisson;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.LineCount;
import majicsim.net.PtyPort;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/** A Hemisson on the bench: the sheet's made-up sensor values, or the standard room's, and both kinds of line. */
final class Bench implements AutoCloseable {
    private static final double STEP_SECONDS = 0.004;

    final World world = new World(Room.standard());
    final HemissonRobot robot;
    final TcpPort tcp;
    final Optional<PtyPort> pty;

    private final ReentrantLock lock = new ReentrantLock(true);
    private long nanos;

    Bench(HemissonOptions options) throws IOException {
        this(options, Bench::madeUp, Noise.exact());
    }

    Bench(HemissonOptions options, @Nullable InfraRedSensors sensors, Noise noise) throws IOException {
        Body body = Body.disc("hemisson", HemissonRobot.RADIUS_MM, new Pose(-2000, -2000, 0));
        robot = new HemissonRobot(world, body, noise, options, sensors);
        Wiring wiring = new Wiring(lock, robot, new Faults(Noise.exact()));
        tcp = TcpPort.open(0, Clients.ONE, wiring);
        pty = PtyPort.open(wiring);
    }

    /** Runs the robot for some steps of lab time. */
    void steps(int count) {
        lock.lock();
        try {
            for (int i = 0; i < count; i++) {
                nanos += 4_000_000;
                world.step(STEP_SECONDS);
                robot.step(STEP_SECONDS);
                tcp.step(nanos);
                pty.ifPresent(port -> port.step(nanos));
            }
        } finally {
            lock.unlock();
        }
    }

    /** Waits until the robot has dealt with so many bytes of its TCP client; the test's time-out bounds it. */
    void awaitConsumed(long bytes) {
        while (tcp.lines().stream().mapToLong(LineCount::consumed).sum() < bytes) {
            Thread.onSpinWait();
        }
    }

    void awaitNoLine() {
        while (!tcp.lines().isEmpty()) {
            Thread.onSpinWait();
        }
    }

    @Override
    public void close() {
        tcp.close();
        pty.ifPresent(PtyPort::close);
    }

    private static void madeUp(int[] ambient, int[] response) {
        Arrays.fill(ambient, 220);
        Arrays.fill(response, 0, 6, 4);
        Arrays.fill(response, 6, 8, 60);
    }
}
