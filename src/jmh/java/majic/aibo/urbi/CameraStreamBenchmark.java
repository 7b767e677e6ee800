package majic.aibo.urbi;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import majic.StandingRobot;
import majic.aibo.AiboType;
import majic.driver.RobotWait;
import majic.link.Links;
import majic.time.TimeSource;
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
 * Measures how many camera frames a second the driver receives from a peer on loopback that sends at full speed,
 * compared with a bare socket that reads the same bytes and discards them.
 *
 * <p>Result: {@link #client} divided by {@link #bareRead}, for each size. {@link #client} times {@code bytes} is the
 * largest data rate that the client can process.
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class CameraStreamBenchmark {
    private static final int CONNECT_MS = 1000;

    /** A peer that only sends one frame repeatedly. */
    @State(Scope.Thread)
    public static class Camera {
        /** The size of one picture, bytes. */
        @Param({"5347", "99840", "1000000"})
        public int bytes;

        private byte[] frame = {};
        private StandingRobot dog;

        /** Starts to listen. */
        @Setup
        public void open() throws IOException {
            byte[] header =
                    ("[00011817:cam] BIN " + bytes + " jpeg 208 160 160\n").getBytes(StandardCharsets.ISO_8859_1);
            frame = new byte[header.length + bytes];
            ThreadLocalRandom.current().nextBytes(frame);
            System.arraycopy(header, 0, frame, 0, header.length);
            dog = new StandingRobot("camera", (client, robot) -> send(client));
        }

        private void send(Socket client) throws IOException {
            while (true) {
                client.getOutputStream().write(frame);
            }
        }

        /** Closes the connection. */
        @TearDown
        public void close() throws IOException {
            dog.close();
        }
    }

    /** The driver's connection. */
    @State(Scope.Thread)
    public static class Client {
        private final Semaphore arrived = new Semaphore(0);
        private UrbiConnection connection;

        /** Connects. */
        @Setup(Level.Iteration)
        public void open(Camera camera) throws IOException {
            TimeSource time = TimeSource.system();
            connection = new UrbiConnection(
                    "pictures",
                    new LinkTransport(Links.of("//127.0.0.1:" + camera.dog.port(), AiboType.PORT, 0), time),
                    new RobotWait(time, time.signal()),
                    message -> arrived.release(),
                    (from, why) -> {
                        throw new IllegalStateException(why);
                    });
            connection.open(CONNECT_MS);
        }

        /** Discards frames that arrived before the next iteration. */
        @TearDown(Level.Iteration)
        public void close() {
            connection.abort();
            arrived.drainPermits();
        }
    }

    /** A bare socket. */
    @State(Scope.Thread)
    public static class Bare {
        private byte[] buffer = {};
        private Socket socket;

        /** Connects. */
        @Setup(Level.Iteration)
        public void open(Camera camera) throws IOException {
            buffer = new byte[camera.frame.length];
            socket = new Socket(InetAddress.getLoopbackAddress(), camera.dog.port());
        }

        /** Closes the connection. */
        @TearDown(Level.Iteration)
        public void close() throws IOException {
            socket.close();
        }
    }

    /** Measures from the bytes to the picture's message. */
    @Benchmark
    public void client(Camera camera, Client client) throws InterruptedException {
        client.arrived.acquire();
    }

    /** Measures the lower bound. */
    @Benchmark
    public int bareRead(Camera camera, Bare bare) throws IOException {
        InputStream in = bare.socket.getInputStream();
        return in.readNBytes(bare.buffer, 0, bare.buffer.length);
    }
}
