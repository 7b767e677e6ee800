package majic.pioneer;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import majic.StandingRobot;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the time of a {@code drive} from the call to writing its packets to the socket, in a running session,
 * compared with only writing the same packets.
 *
 * <p>Result: p0.50 of {@link #drive} divided by p0.50 of {@link #bareWrites}, at most 2; and the same for p0.99. A
 * drive is two packets, VEL and RVEL, each in a write of its own; so is the bare one. Without a pause between them the
 * peer and all threads stay awake; with a pause of 1 ms each write has to wake the peer, as it has to when a user
 * drives.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class DriveBenchmark {
    /** The pause between two drives, µs. */
    @Param({"0", "1000"})
    public int pauseMicros;

    private StandingRobot robot;
    private MajicPioneer driver;
    private SocketChannel bare;
    private ByteBuffer speed;
    private ByteBuffer rate;
    private int step;

    /** Opens a session, and a bare connection to the same peer. */
    @Setup
    public void open() throws IOException {
        robot = StationaryPioneer.open();
        driver = new MajicPioneer("pioneer://127.0.0.1:" + robot.port());
        driver.connect();
        bare = SocketChannel.open(new InetSocketAddress(InetAddress.getLoopbackAddress(), robot.port()));
        bare.setOption(StandardSocketOptions.TCP_NODELAY, true);
        speed = direct(ArcosCommand.VEL.packet(250));
        rate = direct(ArcosCommand.RVEL.packet(-15));
    }

    private static ByteBuffer direct(Packet packet) {
        byte[] bytes = packet.bytes();
        return ByteBuffer.allocateDirect(bytes.length).put(bytes);
    }

    /** Pauses; not measured. */
    @Setup(Level.Invocation)
    public void pause() {
        if (pauseMicros > 0) {
            LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(pauseMicros));
        }
    }

    /** Measures the call. */
    @Benchmark
    public void drive() {
        step = (step + 1) % 100;
        driver.drive(200 + step, step - 50);
    }

    /** Measures the lower bound. */
    @Benchmark
    public int bareWrites() throws IOException {
        return bare.write(speed.flip()) + bare.write(rate.flip());
    }

    /** Closes the session. */
    @TearDown
    public void close() throws IOException {
        driver.close();
        bare.close();
        robot.close();
    }
}
