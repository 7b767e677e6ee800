package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/**
 * A standard server information packet, field by field as sent, under the manual's names (ARCOS sheet 8). Immutable.
 *
 * @param type 0x32 stationary, 0x33 moving; not reliable
 * @param xPos odometry counter, 16 bits
 * @param yPos odometry counter, 16 bits
 * @param thPos heading, 4096 units a turn
 * @param lVel left wheel
 * @param rVel right wheel
 * @param battery 0.1 V
 * @param stallRear bit 0 left motor stalled, bits 1–7 rear bumper segments
 * @param stallFront bit 0 right motor stalled, bits 1–7 front bumper segments
 * @param control heading servo's set-point
 * @param flags bits of ARCOS sheet 8.1
 * @param compass in 2°, 0 for none
 * @param sonar the new readings
 * @param tail what followed
 */
public record Sip(
        int type,
        int xPos,
        int yPos,
        int thPos,
        int lVel,
        int rVel,
        int battery,
        int stallRear,
        int stallFront,
        int control,
        int flags,
        int compass,
        SonarReadings sonar,
        SipTail tail) {
    /** Bytes up to and with the sonar count. */
    private static final int HEAD_BYTES = 19;

    /** A disc number and a range. */
    private static final int READING_BYTES = 3;

    /**
     * Decodes a packet.
     *
     * @return the fields; null if it is too short to be a SIP
     */
    public static @Nullable Sip decode(Packet packet) {
        FieldReader fields = packet.fields();
        if (fields.remaining() < HEAD_BYTES) {
            return null;
        }
        return new Sip(
                packet.type(),
                fields.uint(),
                fields.uint(),
                fields.sint(),
                fields.sint(),
                fields.sint(),
                fields.ubyte(),
                fields.ubyte(),
                fields.ubyte(),
                fields.sint(),
                fields.uint(),
                fields.ubyte(),
                sonar(fields),
                SipTail.read(fields));
    }

    /** This SIP with other sonar readings. */
    Sip with(SonarReadings readings) {
        return new Sip(
                type,
                xPos,
                yPos,
                thPos,
                lVel,
                rVel,
                battery,
                stallRear,
                stallFront,
                control,
                flags,
                compass,
                readings,
                tail);
    }

    /**
     * A count that the packet cannot hold is ignored: the vendor's simulator sends one such SIP after SONAR 1 (ARCOS
     * sheet 8.2), with its tail right behind the count.
     */
    private static SonarReadings sonar(FieldReader fields) {
        int count = fields.ubyte();
        return count * READING_BYTES <= fields.remaining() ? SonarReadings.read(fields, count) : SonarReadings.NONE;
    }
}
