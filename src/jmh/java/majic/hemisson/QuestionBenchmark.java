package majic.hemisson;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import majic.bot.Unit;
import majic.bot.Value;
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
 * Measures the time of a query and its reply over a pseudo-terminal, compared with a bare loop of jSerialComm that
 * writes and reads the same bytes at a second one.
 *
 * <p>Result: p0.50 of {@link #ask} divided by p0.50 of {@link #bareLoop}; and the same for p0.99. The difference is one
 * thread waking another: the reader, which serves all threads, wakes the one that sent the query. One of the driver's
 * own polls, ten a second, may precede a query.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class QuestionBenchmark {
    private static final int BAUD = 115_200;
    private static final byte[] QUESTION = "R,C0,10,01\r".getBytes(StandardCharsets.ISO_8859_1);

    private final byte[] buffer = new byte[64];
    private PortHemisson robot;
    private PortHemisson other;
    private MajicHemisson driver;
    private SerialPort bare;

    /** Connects the driver, and a bare port to a peer of the same kind. */
    @Setup
    public void open() throws IOException {
        robot = PortHemisson.stock();
        other = PortHemisson.stock();
        robot.remembersNothing();
        other.remembersNothing();
        driver = new MajicHemisson("hemisson:" + robot.name());
        driver.connect();
        bare = SerialPort.getCommPort(other.name());
        bare.setComPortParameters(BAUD, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        bare.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
        if (!bare.openPort()) {
            throw new IOException("cannot open " + other.name());
        }
    }

    /** Measures one query of a value that is not polled. */
    @Benchmark
    public String ask() {
        return driver.run("i2cRead", List.of(Value.text("C0"), Value.text("10"), Value.of(1, Unit.NONE)));
    }

    /** Measures the lower bound. */
    @Benchmark
    public int bareLoop() throws IOException {
        bare.writeBytes(QUESTION, QUESTION.length);
        int total = 0;
        while (total == 0 || buffer[total - 1] != '\n') {
            int count = bare.readBytes(buffer, buffer.length - total, total);
            if (count < 0) {
                throw new IOException("the port is gone");
            }
            total += count;
        }
        return total;
    }

    /** Closes all connections. */
    @TearDown
    public void close() {
        driver.close();
        bare.closePort();
        robot.close();
        other.close();
    }
}
