package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;

/**
 * A standard server information packet: its fields as sent, and the sonar readings that are new in it (ARCOS sheet 8).
 * Immutable.
 */
public final class Sip {
    /** The value of a field that did not come. */
    public static final int ABSENT = Integer.MIN_VALUE;

    private static final SipField[] FIELDS = SipField.values();
    private static final int TAIL = SipField.GRIP_STATE.ordinal();

    /** Where the number of sonar readings is, behind the fields that every robot sends. */
    private static final int COUNT_AT = 18;

    /** A disc number and a range. */
    private static final int READING_BYTES = 3;

    private static final String ABSENT_WORD = "-";

    private final long[] fields;

    /** Number and range of a disc in turn. */
    private final int[] sonar;

    private Sip(long[] fields, int[] sonar) {
        this.fields = fields;
        this.sonar = sonar;
    }

    /**
     * Decodes a packet.
     *
     * @return the fields; null if it is too short to be a SIP
     */
    public static @Nullable Sip decode(Packet packet) {
        byte[] data = packet.data;
        if (data.length <= COUNT_AT) {
            return null;
        }
        long[] fields = new long[FIELDS.length];
        read(data, 0, fields, 0, TAIL);
        fields[0] = packet.type;
        int[] sonar = sonar(data);
        read(data, COUNT_AT + 1 + sonar.length / 2 * READING_BYTES, fields, TAIL, FIELDS.length);
        return new Sip(fields, sonar);
    }

    /** Reads fields, low byte first. A partial one did not come, nor did those behind it. */
    private static void read(byte[] data, int from, long[] fields, int first, int end) {
        int at = from;
        for (int index = first; index < end; index++) {
            SipField field = FIELDS[index];
            if (at + field.bytes > data.length) {
                Arrays.fill(fields, index, end, ABSENT);
                return;
            }
            long value = 0;
            for (int shift = 0; shift < 8 * field.bytes; shift += 8) {
                value |= (data[at++] & 0xFFL) << shift;
            }
            int unused = Long.SIZE - 8 * field.bytes;
            fields[index] = field.signed ? value << unused >> unused : value;
        }
    }

    /**
     * A count that the packet cannot hold is ignored: the vendor's simulator sends one such SIP after SONAR 1 (ARCOS
     * sheet 8.2), with its tail right behind the count.
     */
    private static int[] sonar(byte[] data) {
        int count = data[COUNT_AT] & 0xFF;
        int at = COUNT_AT + 1;
        if (at + count * READING_BYTES > data.length) {
            return new int[0];
        }
        int[] sonar = new int[2 * count];
        for (int index = 0; index < sonar.length; index += 2) {
            sonar[index] = data[at] & 0xFF;
            sonar[index + 1] = data[at + 1] & 0xFF | (data[at + 2] & 0xFF) << 8;
            at += READING_BYTES;
        }
        return sonar;
    }

    /**
     * A SIP from elsewhere than a packet.
     *
     * @param known the fields that are known, as the robot would send them
     * @param ranges new ranges by the number of their disc, as the robot would send them
     */
    public static Sip of(Map<SipField, Integer> known, Map<Integer, Integer> ranges) {
        long[] fields = new long[FIELDS.length];
        for (SipField field : FIELDS) {
            fields[field.ordinal()] = known.getOrDefault(field, ABSENT);
        }
        return new Sip(
                fields,
                ranges.entrySet().stream()
                        .flatMapToInt(reading -> IntStream.of(reading.getKey(), reading.getValue() & 0xFFFF))
                        .toArray());
    }

    /**
     * Reads what {@link #text} has written.
     *
     * @throws IllegalArgumentException if the text is no SIP
     */
    public static Sip parse(String text) {
        String[] words = text.split(" ");
        if (words.length < FIELDS.length) {
            throw new IllegalArgumentException("the SIP is too short");
        }
        long[] numbers = Arrays.stream(words)
                .mapToLong(word -> word.equals(ABSENT_WORD) ? ABSENT : Long.parseLong(word))
                .toArray();
        return new Sip(
                Arrays.copyOf(numbers, FIELDS.length),
                Arrays.stream(numbers, FIELDS.length, numbers.length)
                        .mapToInt(number -> (int) number)
                        .toArray());
    }

    /** A line of text, for recordings: the fields, {@code -} for one that did not come, then disc and range in turn. */
    public String text() {
        return LongStream.concat(Arrays.stream(fields), Arrays.stream(sonar).asLongStream())
                .mapToObj(field -> field == ABSENT ? ABSENT_WORD : String.valueOf(field))
                .collect(Collectors.joining(" "));
    }

    /** Whether a field came. */
    public boolean has(SipField field) {
        return fields[field.ordinal()] != ABSENT;
    }

    /** A field of at most 16 bits; {@link #ABSENT} if it did not come. */
    public int get(SipField field) {
        return (int) fields[field.ordinal()];
    }

    /** Any field; {@link #ABSENT} if it did not come. */
    public long number(SipField field) {
        return fields[field.ordinal()];
    }

    /** How many sonar readings came. */
    public int readings() {
        return sonar.length / 2;
    }

    /** The number of the disc of a reading, 0 to 255; only those that the model has mean anything. */
    public int disc(int reading) {
        return sonar[2 * reading];
    }

    /** The range of a reading as sent, in the model's unit. */
    public int range(int reading) {
        return sonar[2 * reading + 1];
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Sip sip && Arrays.equals(sip.fields, fields) && Arrays.equals(sip.sonar, sonar);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(fields) + Arrays.hashCode(sonar);
    }

    @Override
    public String toString() {
        return "SIP " + text();
    }
}
