package majicsim.pioneer.report;

import java.util.List;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.pioneer.ranging.SonarReading;

/**
 * The standard packet about the robot's state (ARCOS sheet 8).
 *
 * @param motion pose and speed
 * @param status the robot's status
 * @param sonar new readings only, at most 50, so that no tail makes it too long
 * @param tail the fields after the sonar readings
 */
record Sip(SipMotion motion, SipStatus status, List<SonarReading> sonar, SipTail tail) {
    private static final int STATIONARY = 0x32;
    private static final int MOVING = 0x33;

    /** The state now. Takes the sonar readings, which are reported only once. */
    static Sip of(Board board) {
        return new Sip(SipMotion.of(board), SipStatus.of(board), board.sonar().takeFresh(), SipTail.of(board));
    }

    byte[] toBytes() {
        PacketWriter packet = new PacketWriter(motion.isMoving() ? MOVING : STATIONARY);
        packet.uint16s(motion.x(), motion.y(), motion.heading(), motion.leftSpeed(), motion.rightSpeed());
        packet.uint8(Math.min(0xFF, status.batteryTenthVolts()))
                .uint8(status.left())
                .uint8(status.right());
        packet.uint16s(motion.control(), status.flags()).uint8(status.compass());
        packet.uint8(sonar.size());
        for (SonarReading reading : sonar) {
            packet.uint8(reading.disc()).uint16(reading.range());
        }
        tail.write(packet, status.batteryTenthVolts(), motion.turnRate());
        return packet.toBytes();
    }
}
