package majic.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures how many camera frames a second one core converts from the connection's chunks to the pictures' bytes.
 *
 * <p>Result: frames a second times {@code bytes}, the largest data rate that the decoder can process; compare the
 * largest with the smallest size, whose quotient must stay near 1 or above. A dog sends about 30 frames a second; a
 * JPEG of 208 × 160 has about 5 KB (URBI sheet 12), the same picture raw 99,840 bytes, the largest frame here 1 MB.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class CameraBenchmark {
    private static final int CHUNK_BYTES = 4096;

    /** The size of one frame, bytes. */
    @Param({"5347", "99840", "1000000"})
    public int bytes;

    private final UrbiDecoder decoder = new UrbiDecoder();
    private byte[][] chunks = {};

    /** Makes one frame, divided into chunks as a reader receives it. */
    @Setup
    public void cut() {
        byte[] header = ("[00011817:cam] BIN " + bytes + " jpeg 208 160 160\n").getBytes(StandardCharsets.ISO_8859_1);
        byte[] frame = new byte[header.length + bytes];
        ThreadLocalRandom.current().nextBytes(frame);
        System.arraycopy(header, 0, frame, 0, header.length);
        int count = (frame.length + CHUNK_BYTES - 1) / CHUNK_BYTES;
        chunks = new byte[count][];
        for (int at = 0; at < count; at++) {
            chunks[at] = Arrays.copyOfRange(frame, at * CHUNK_BYTES, Math.min(frame.length, (at + 1) * CHUNK_BYTES));
        }
    }

    /** Measures from the bytes to the picture's message. */
    @Benchmark
    public List<UrbiMessage> decode() {
        List<UrbiMessage> found = List.of();
        for (byte[] chunk : chunks) {
            found = decoder.feed(chunk, chunk.length);
        }
        return found;
    }
}
