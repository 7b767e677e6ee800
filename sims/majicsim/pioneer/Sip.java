package majicsim.pioneer;

import java.util.List;

/**
 * The standard packet about the robot's state (ARCOS sheet 8), with the tail up to the state of charge.
 *
 * @param motion where and how fast
 * @param status how it is
 * @param sonar new readings only, at most 53
 */
record Sip(SipMotion motion, SipStatus status, List<SonarReading> sonar) {
    static final int DIGITAL_INPUTS_IDLE = 0xFF;

    private static final int STANDING = 0x32;
    private static final int MOVING = 0x33;
    private static final int NOT_CHARGING = 0;
    private static final int NO_TEMPERATURE = -127;
    private static final int CHARGE_NOT_KNOWN = 0;

    byte[] toBytes() {
        PacketWriter packet = new PacketWriter(motion.isMoving() ? MOVING : STANDING);
        packet.uint16s(motion.x(), motion.y(), motion.heading(), motion.leftSpeed(), motion.rightSpeed());
        packet.uint8(Math.min(0xFF, status.batteryTenthVolts()))
                .uint8(status.left())
                .uint8(status.right());
        packet.uint16s(motion.control(), status.flags()).uint8(0);
        writeSonar(packet);
        writeTail(packet);
        return packet.toBytes();
    }

    private void writeSonar(PacketWriter packet) {
        packet.uint8(sonar.size());
        for (SonarReading reading : sonar) {
            packet.uint8(reading.disc()).uint16(reading.range());
        }
    }

    /** From the gripper's state to the state of charge; no gripper, no faults, no sideways speed. */
    private void writeTail(PacketWriter packet) {
        packet.uint8(0).uint8(status.analogPort()).uint8(0);
        packet.uint8(DIGITAL_INPUTS_IDLE).uint8(status.digitalOut());
        packet.uint16(status.batteryTenthVolts()).uint8(NOT_CHARGING);
        packet.uint16s(motion.turnRate(), 0, 0);
        packet.uint8(NO_TEMPERATURE).uint8(CHARGE_NOT_KNOWN);
    }
}
