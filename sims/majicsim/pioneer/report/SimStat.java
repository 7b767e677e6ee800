package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.world.Pose;

/**
 * The simulator's own packet, the only one with the true pose (ARCOS sheet 11.7).
 *
 * @param stepMs the simulator's step
 * @param truePose the true pose of the robot in the room
 * @param odometryError the error of its odometry since it was last set
 */
public record SimStat(int stepMs, Pose truePose, Pose odometryError) {
    private static final int TYPE = 0x62;
    private static final int HAS_ODOMETRY_ERROR = 1 << 2;
    private static final int NO_GPS = -1;

    public static SimStat of(Board board) {
        Pose believed = board.drive().odometry();
        Pose right = board.drive().odometryWithoutError();
        Pose error = new Pose(
                believed.xMm() - right.xMm(), believed.yMm() - right.yMm(), believed.headingDeg() - right.headingDeg());
        return new SimStat(board.stepMs(), board.truePose(), error);
    }

    public byte[] toBytes() {
        PacketWriter packet = new PacketWriter(TYPE).uint8(0).uint8(0).int32(HAS_ODOMETRY_ERROR);
        packet.uint16s(stepMs, stepMs, stepMs);
        int32s(packet, truePose.xMm(), truePose.yMm(), 0, truePose.headingDeg());
        int32s(packet, 0, 0, 0, NO_GPS);
        int32s(packet, odometryError.xMm(), odometryError.yMm(), odometryError.headingDeg());
        return packet.toBytes();
    }

    private static void int32s(PacketWriter packet, double... values) {
        for (double value : values) {
            packet.int32((int) Math.round(value));
        }
    }
}
