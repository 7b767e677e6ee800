package majicsim.pioneer.devices;

import java.util.ArrayDeque;
import java.util.Deque;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.world.Noise;

/**
 * The gyro: measures how the robot truly turns, independent of wheel slip, with a rest value that drifts in a noisy
 * lab. A packet carries the samples since the last (ARCOS sheet 11.6); raw 512 is rest, and raw times the sheet's
 * GyroScaler is deg/s.
 */
public final class Gyro {
    private static final double DEG_PER_SEC_PER_UNIT = 1.626;
    private static final int REST = 512;
    private static final int TOP = 1023;
    private static final long SAMPLE_NANOS = 25_000_000L;
    private static final int SAMPLES_A_CYCLE = 4;
    private static final double SIGMA_DEG_PER_SEC = 0.8;
    /** How much the rest value drifts from sample to sample: some 0.2 deg/s in a minute. */
    private static final double DRIFT_DEG_PER_SEC = 0.004;

    private final Noise noise;
    private final Deque<Integer> samples = new ArrayDeque<>();
    private double driftDegPerSec;
    private long sinceSampleNanos;

    Gyro(Noise noise) {
        this.noise = noise;
    }

    /** Lets time pass while the robot truly turns at this rate. */
    void step(long nanos, double degPerSec) {
        sinceSampleNanos += nanos;
        while (sinceSampleNanos >= SAMPLE_NANOS) {
            sinceSampleNanos -= SAMPLE_NANOS;
            sample(degPerSec);
        }
    }

    public byte[] toBytes(int celsius) {
        PacketWriter packet = new PacketWriter(0x98).uint8(samples.size());
        samples.forEach(sample -> packet.uint16(sample).uint8(celsius));
        samples.clear();
        return packet.toBytes();
    }

    private void sample(double degPerSec) {
        driftDegPerSec += noise.gaussian(DRIFT_DEG_PER_SEC);
        double felt = degPerSec + driftDegPerSec + noise.gaussian(SIGMA_DEG_PER_SEC);
        samples.add(Math.max(0, Math.min(TOP, REST + (int) Math.round(felt / DEG_PER_SEC_PER_UNIT))));
        if (samples.size() > SAMPLES_A_CYCLE) {
            samples.remove();
        }
    }
}
