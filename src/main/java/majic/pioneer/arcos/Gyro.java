package majic.pioneer.arcos;

import java.util.ArrayList;
import java.util.List;

/**
 * The gyro's samples since the last such packet (ARCOS sheet 11.6; their spacing and sign as ARIA reads them).
 * Immutable.
 *
 * @param samples the oldest first, 25 ms apart
 */
public record Gyro(List<Sample> samples) implements Report {
    static final int TYPE = 0x98;
    private static final int SAMPLE_BYTES = 3;

    /**
     * One of them. Immutable.
     *
     * @param rate 0 to 1023, about 512 at rest, less when turning counterclockwise
     * @param temperature in the gyro's own unit
     */
    public record Sample(int rate, int temperature) {}

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
}
