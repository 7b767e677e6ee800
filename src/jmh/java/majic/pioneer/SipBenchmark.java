package majic.pioneer;

import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import majic.bot.Pose;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.FrameDecoder;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.StateTracker;
import org.jspecify.annotations.Nullable;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures how many SIPs of 16 sonar readings one core converts from the connection's bytes to fields and to the
 * published state.
 *
 * <p>Result: {@link #track} divided by {@link #decode}, the share of the time that decoding takes. {@link #decode} must
 * reach at least 2 SIPs a microsecond; {@code gc.alloc.rate.norm} is the number of bytes allocated for each.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class SipBenchmark {
    private static final long CYCLE_NANOS = 100_000_000;

    private final byte[] wire = Bytes.of(Bytes.TURNING_RIGHT);
    private final FrameDecoder decoder = new FrameDecoder();
    private final StateTracker tracker = new StateTracker(Models.of("p3dx"), Pose.START);
    private final Consumer<Packet> keep = packet -> sip = Sip.decode(packet);
    private @Nullable Sip sip;
    private long nanos;

    /** Measures from the bytes to fields. */
    @Benchmark
    public @Nullable Sip decode() {
        decoder.feed(wire, wire.length, keep);
        return sip;
    }

    /** Measures from the bytes to the published state. */
    @Benchmark
    public PioneerState track() {
        nanos += CYCLE_NANOS;
        return tracker.track(decode(), nanos);
    }
}
