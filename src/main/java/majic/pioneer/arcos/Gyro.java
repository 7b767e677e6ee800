package majic.pioneer.arcos;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * The gyro's samples since the last such packet (ARCOS sheet 11.6; their spacing and sign as ARIA reads them).
 * Immutable.
 *
 * @param samples the oldest first, 25 ms apart
 */
public record Gyro(List<Sample> samples) implements Report {
    private static final int SAMPLE_BYTES = 3;

    /**
     * One of them. Immutable.
     *
     * @param rate 0 to 1023, about 512 at rest, less when turning counterclockwise
     * @param temperature in the gyro's own unit
     */
    public record Sample(int rate, int temperature) {}

    private static final int REST = 512;

    /** Of every model; ARIA calls it GyroScaler (ARCOS sheet 9.1). */
    private static final double SCALER = 1.626;

    /** As in ARIA: 300 deg/s are 2.5 V, and 5 V are 1023 counts. Not tested on a robot. */
    private static final double DEG_PER_SEC_PER_COUNT = 5.0 / 1023 * 300 / 2.5 * SCALER;

    /** Keeps a copy. */
    public Gyro {
        samples = List.copyOf(samples);
    }

    static Gyro read(FieldReader fields) {
        int count = fields.ubyte();
        List<Sample> samples = new ArrayList<>();
        while (samples.size() < count && fields.remaining() >= SAMPLE_BYTES) {
            samples.add(new Sample(fields.uint(), fields.ubyte()));
        }
        return new Gyro(samples);
    }

    /** The mean turn rate, deg/s, counterclockwise positive; empty without samples. */
    public OptionalDouble degPerSec() {
        return samples.stream()
                .mapToDouble(sample -> (REST - sample.rate()) * DEG_PER_SEC_PER_COUNT)
                .average();
    }
}
