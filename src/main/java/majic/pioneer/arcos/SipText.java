package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.LongStream;

/**
 * A SIP as a line of text, for recordings: its fields in the order of the packet, then those of its tail, {@code -} for
 * one that did not come, then number and range of each sonar reading.
 */
public final class SipText {
    private static final String ABSENT = "-";

    private SipText() {}

    /** Writes a SIP. */
    public static String of(Sip sip) {
        SipTail tail = sip.tail();
        LongStream fields = LongStream.of(
                sip.type(),
                sip.xPos(),
                sip.yPos(),
                sip.thPos(),
                sip.lVel(),
                sip.rVel(),
                sip.battery(),
                sip.stallRear(),
                sip.stallFront(),
                sip.control(),
                sip.flags(),
                sip.compass(),
                tail.gripState(),
                tail.analogPort(),
                tail.analog(),
                tail.digIn(),
                tail.digOut(),
                tail.batteryTenths(),
                tail.chargeState(),
                tail.turnRateTenths(),
                tail.faultFlags(),
                tail.sidewaysMmPerSec(),
                tail.temperature(),
                tail.chargePercent(),
                tail.clockMicros(),
                tail.flags3());
        return LongStream.concat(fields, readings(sip.sonar()))
                .mapToObj(field -> field == SipTail.ABSENT ? ABSENT : String.valueOf(field))
                .collect(Collectors.joining(" "));
    }

    private static LongStream readings(SonarReadings sonar) {
        return LongStream.range(0, sonar.count())
                .flatMap(index -> LongStream.of(sonar.disc((int) index), sonar.range((int) index)));
    }

    /**
     * Reads a SIP.
     *
     * @throws IllegalArgumentException if the text is no SIP
     */
    public static Sip parse(String text) {
        Fields fields = new Fields(text);
        return new Sip(
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        fields.next(),
                        SonarReadings.NONE,
                        tail(fields))
                .with(SonarReadings.of(fields.readings()));
    }

    private static SipTail tail(Fields fields) {
        return new SipTail(
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.next(),
                fields.nextLong(),
                fields.nextLong());
    }

    /** The words of a text, one after the other. */
    private static final class Fields {
        private final Iterator<String> words;

        Fields(String text) {
            words = Arrays.asList(text.split(" ")).iterator();
        }

        long nextLong() {
            if (!words.hasNext()) {
                throw new IllegalArgumentException("the SIP is too short");
            }
            String word = words.next();
            return word.equals(ABSENT) ? SipTail.ABSENT : Long.parseLong(word);
        }

        int next() {
            return (int) nextLong();
        }

        Map<Integer, Integer> readings() {
            Map<Integer, Integer> ranges = new LinkedHashMap<>();
            while (words.hasNext()) {
                ranges.put(next(), next());
            }
            return ranges;
        }
    }
}
