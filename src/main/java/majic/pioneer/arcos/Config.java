package majic.pioneer.arcos;

/**
 * The answer to CONFIG, as far as the driver has a use for it (ARCOS sheet 10). Fields that did not come are zero or
 * empty. Immutable.
 *
 * @param robotClass {@code Pioneer} for nearly all
 * @param subclass the model
 * @param serialNumber {@code SIM} for the vendor's simulator
 * @param turnTopDegPerSec what the robot can never exceed
 * @param speedTopMmPerSec what the robot can never exceed
 * @param name the owner's name for it
 * @param cycleMs time from one SIP to the next
 * @param hasFrontSonar whether it has the front array
 * @param hasRearSonar whether it has the rear array
 * @param watchdogMs after how long without a packet it stops; 0 for never
 * @param turnMaxDegPerSec set now
 * @param speedMaxMmPerSec set now
 * @param frontBumpers segments
 * @param rearBumpers segments
 * @param autobaud 1 can change, 2 automatic
 * @param version of the firmware
 */
public record Config(
        String robotClass,
        String subclass,
        String serialNumber,
        int turnTopDegPerSec,
        int speedTopMmPerSec,
        String name,
        int cycleMs,
        boolean hasFrontSonar,
        boolean hasRearSonar,
        int watchdogMs,
        int turnMaxDegPerSec,
        int speedMaxMmPerSec,
        int frontBumpers,
        int rearBumpers,
        int autobaud,
        String version) {
    /** The type of the packet. */
    public static final int TYPE = 0x20;

    /** Decodes a packet; the numbers in the comments are the sheet's. */
    public static Config decode(Packet packet) {
        Fields fields = packet.fields();
        String robotClass = fields.string();
        String subclass = fields.string();
        String serialNumber = fields.string();
        fields.ubyte(); // 4
        int turnTop = fields.uint();
        int speedTop = fields.uint();
        skip(fields, 3); // 7–9
        String name = fields.string();
        int cycleMs = fields.ubyte();
        fields.uint(); // 12, 13: two bytes
        fields.uint(); // 14
        boolean front = fields.uint() != 0;
        boolean rear = fields.ubyte() != 0;
        skip(fields, 2); // 17, 18
        int watchdogMs = fields.uint();
        fields.ubyte(); // 20
        skip(fields, 4); // 21–24
        int turnMax = fields.uint();
        int speedMax = fields.uint();
        skip(fields, 10); // 27–36
        int frontBumpers = fields.ubyte();
        int rearBumpers = fields.ubyte();
        fields.uint(); // 39, 40: two bytes
        int autobaud = fields.ubyte();
        fields.ubyte(); // 42
        skip(fields, 4); // 43; 44 and 45: two bytes; 46, 47
        return new Config(
                robotClass,
                subclass,
                serialNumber,
                turnTop,
                speedTop,
                name,
                cycleMs,
                front,
                rear,
                watchdogMs,
                turnMax,
                speedMax,
                frontBumpers,
                rearBumpers,
                autobaud,
                fields.string());
    }

    private static void skip(Fields fields, int uints) {
        for (int index = 0; index < uints; index++) {
            fields.uint();
        }
    }
}
