package majic.pioneer.arcos;

import java.util.Map;

/** The sonar readings that came new with one SIP, in its order (ARCOS sheet 8.2). Immutable. */
public final class SonarReadings {
    static final SonarReadings NONE = new SonarReadings(new int[0]);

    private final int[] packed;

    private SonarReadings(int[] packed) {
        this.packed = packed;
    }

    /** Reads that many disc numbers and ranges. */
    static SonarReadings read(FieldReader fields, int count) {
        int[] packed = new int[count];
        for (int index = 0; index < count; index++) {
            int disc = fields.ubyte();
            packed[index] = disc << 16 | fields.uint();
        }
        return new SonarReadings(packed);
    }

    /** Readings from elsewhere than a SIP: ranges by the number of their disc. */
    public static SonarReadings of(Map<Integer, Integer> ranges) {
        return new SonarReadings(ranges.entrySet().stream()
                .mapToInt(reading -> reading.getKey() << 16 | reading.getValue() & 0xFFFF)
                .toArray());
    }

    /** How many there are. */
    public int count() {
        return packed.length;
    }

    /** The number of a disc, 0 to 255; only those the model has mean anything. */
    public int disc(int index) {
        return packed[index] >> 16;
    }

    /** Its range as sent, in the model's unit. */
    public int range(int index) {
        return packed[index] & 0xFFFF;
    }
}
