package majic.pioneer.arcos;

import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * A part of a scan by the laser of a simulator, as one packet carries it (ARCOS sheet 11.8). The pose in packets of
 * type 0x60 is left out: it has whole degrees only, and the SIPs have it finer. Immutable.
 */
public final class LaserChunk {
    private static final int WITH_POSE = 0x60;
    private static final int WITH_REFLECTANCE = 0x61;

    /** A range; with a reflectance and two zero bytes behind it. */
    private static final int RANGE_BYTES = 2;

    private static final int REFLECTANCE_BYTES = 3;

    /** A step of 0.1 degrees all around has fewer. */
    private static final int MOST_READINGS = 4096;

    private final int laser;
    private final int total;
    private final int first;
    private final int[] rangesMm;

    private LaserChunk(int laser, int total, int first, int[] rangesMm) {
        this.laser = laser;
        this.total = total;
        this.first = first;
        this.rangesMm = rangesMm;
    }

    /**
     * Decodes a packet.
     *
     * @return null if it is of no such type, too short for its readings, or has readings that the scan does not have
     */
    public static @Nullable LaserChunk decode(Packet packet) {
        if (packet.type != WITH_POSE && packet.type != WITH_REFLECTANCE) {
            return null;
        }
        FieldReader fields = packet.fields();
        if (packet.type == WITH_POSE) {
            IntStream.range(0, 3).forEach(field -> fields.sint());
        }
        int total = fields.uint();
        int first = fields.uint();
        int count = fields.ubyte();
        int unread = packet.type == WITH_REFLECTANCE ? REFLECTANCE_BYTES : 0;
        boolean fits = first + count <= total && count * (RANGE_BYTES + unread) <= fields.remaining();
        if (count == 0 || !fits || total > MOST_READINGS) {
            return null;
        }
        int[] rangesMm = new int[count];
        for (int index = 0; index < count; index++) {
            rangesMm[index] = fields.uint();
            fields.ubytes(unread);
        }
        return new LaserChunk(fields.ubyte(), total, first, rangesMm);
    }

    /** The number of the laser; 0 if the packet does not tell. */
    public int laser() {
        return laser;
    }

    /** How many readings the whole scan has. */
    public int total() {
        return total;
    }

    /** The index of its first reading in the scan. */
    public int first() {
        return first;
    }

    /** The index behind its last reading in the scan. */
    public int end() {
        return first + rangesMm.length;
    }

    /**
     * One of its readings.
     *
     * @param index in the scan, {@link #first} to {@link #end}, excluded
     * @return mm
     */
    public int rangeMm(int index) {
        return rangesMm[index - first];
    }
}
