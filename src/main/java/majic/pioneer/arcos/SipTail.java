package majic.pioneer.arcos;

/**
 * What may follow the sonar readings in a SIP; older firmware sends less of it (ARCOS sheet 8). A field that did not
 * come is {@link #ABSENT}. Immutable.
 *
 * @param gripState gripper, bits
 * @param analogPort which port {@code analog} is of
 * @param analog 0 to 255 for 0 to 5 V
 * @param digIn digital inputs, bits
 * @param digOut digital outputs, bits
 * @param batteryTenths true voltage, 0.1 V
 * @param chargeState 255 unknown, 0 not charging, 1 bulk, 2 overcharge, 3 float, 4 balance
 * @param turnRateTenths 0.1 deg/s, counterclockwise positive
 * @param faultFlags 0 = fine
 * @param sidewaysMmPerSec 0 on robots with two driven wheels
 * @param temperature °C; −128 and −127 for none
 * @param chargePercent 0 = not known
 * @param clockMicros the controller's clock, µs
 * @param flags3 bits of the newest firmware
 */
public record SipTail(
        int gripState,
        int analogPort,
        int analog,
        int digIn,
        int digOut,
        int batteryTenths,
        int chargeState,
        int turnRateTenths,
        int faultFlags,
        int sidewaysMmPerSec,
        int temperature,
        int chargePercent,
        long clockMicros,
        long flags3) {
    /** The value of a field that did not come. */
    public static final int ABSENT = Integer.MIN_VALUE;

    /** Reads what is left of a SIP. */
    static SipTail read(FieldReader rest) {
        return new SipTail(
                rest.ubyteOr(ABSENT),
                rest.ubyteOr(ABSENT),
                rest.ubyteOr(ABSENT),
                rest.ubyteOr(ABSENT),
                rest.ubyteOr(ABSENT),
                rest.uintOr(ABSENT),
                rest.ubyteOr(ABSENT),
                rest.sintOr(ABSENT),
                rest.uintOr(ABSENT),
                rest.sintOr(ABSENT),
                rest.sbyteOr(ABSENT),
                rest.sbyteOr(ABSENT),
                rest.uint32Or(ABSENT),
                rest.uint32Or(ABSENT));
    }
}
