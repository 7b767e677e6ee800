package majic.aibo;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import majic.StandingRobot;
import majic.aibo.session.AiboSession;
import majic.aibo.urbi.UrbiValue;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures how many successive queries a second the driver completes over loopback, compared with a bare socket that
 * exchanges the same bytes with the same peer.
 *
 * <p>Result: {@link #get} divided by {@link #bareEcho}. The difference is one thread waking another: the reader, which
 * serves all threads, wakes the one that sent the query.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class GetBenchmark {
    private static final double ANSWER_S = 2;
    private static final byte[] QUESTION = "mjabcd_1000: headPan.val;\n".getBytes(StandardCharsets.ISO_8859_1);

    private final byte[] buffer = new byte[4096];
    private StandingRobot dog;
    private MajicAibo driver;
    private Socket bare;

    /** Connects the driver, and a bare socket, to the same peer. */
    @Setup
    public void open() throws IOException {
        dog = StandingDog.open();
        driver = new MajicAibo("aibo://127.0.0.1:" + dog.port());
        driver.connect();
        bare = new Socket(InetAddress.getLoopbackAddress(), dog.port());
        bare.setTcpNoDelay(true);
        readTo(StandingDog.INTRODUCTION.length());
    }

    /** Measures reading a parameter that is not streamed. */
    @Benchmark
    public UrbiValue get() {
        AiboSession session = driver.session();
        return session.questions().ask(session.connections().stop(), "headPan.val", ANSWER_S);
    }

    /** Measures the lower bound. */
    @Benchmark
    public int bareEcho() throws IOException {
        bare.getOutputStream().write(QUESTION);
        return readTo(1);
    }

    /** Reads at least a number of bytes, up to the end of a line. */
    private int readTo(int least) throws IOException {
        InputStream in = bare.getInputStream();
        int total = 0;
        while (total < least || buffer[total - 1] != '\n') {
            int count = in.read(buffer, total, buffer.length - total);
            if (count < 0) {
                throw new IOException("the dog hung up");
            }
            total += count;
        }
        return total;
    }

    /** Closes the connections. */
    @TearDown
    public void close() throws IOException {
        driver.close();
        bare.close();
        dog.close();
    }
}
