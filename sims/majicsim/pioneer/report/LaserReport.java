package majicsim.pioneer.report;

import java.util.ArrayList;
import java.util.List;
import majicsim.pioneer.packet.PacketWriter;
import majicsim.world.Pose;

/**
 * The packets of one laser scan (ARCOS sheet 11.8): 0x60 with the robot's pose, or 0x61 with a reflectance beside each
 * range.
 *
 * @param odometry the pose that 0x60 carries
 * @param ranges in mm, in the order of the scan
 */
public record LaserReport(Pose odometry, int[] ranges) {
    private static final int WITH_POSE = 0x60;
    private static final int WITH_REFLECTANCE = 0x61;
    private static final int MOST_IN_A_PACKET = 32;
    /** The reflectance of every surface: the room has no reflectors. */
    private static final int NO_REFLECTANCE = 0;

    private static final int ONLY_LASER = 0;

    public List<byte[]> withPose() {
        List<byte[]> packets = new ArrayList<>();
        for (int first = 0; first < ranges.length; first += MOST_IN_A_PACKET) {
            PacketWriter packet = new PacketWriter(WITH_POSE);
            packet.uint16s((int) odometry.xMm(), (int) odometry.yMm(), (int) odometry.headingDeg());
            for (int i = begin(packet, first); i > 0; i--) {
                packet.uint16(ranges[endOf(first) - i]);
            }
            packets.add(packet.toBytes());
        }
        return packets;
    }

    /** Reports once that the robot was put elsewhere in the room. */
    public List<byte[]> withReflectance(boolean lifted) {
        List<byte[]> packets = new ArrayList<>();
        for (int first = 0; first < ranges.length; first += MOST_IN_A_PACKET) {
            PacketWriter packet = new PacketWriter(WITH_REFLECTANCE);
            for (int i = begin(packet, first); i > 0; i--) {
                packet.uint16(ranges[endOf(first) - i]).uint8(NO_REFLECTANCE).uint16(0);
            }
            packet.uint8(ONLY_LASER).uint8(lifted && first == 0 ? 1 : 0);
            packets.add(packet.toBytes());
        }
        return packets;
    }

    /** Writes how many readings there are, which is the first here, and how many follow; returns the latter. */
    private int begin(PacketWriter packet, int first) {
        int here = endOf(first) - first;
        packet.uint16s(ranges.length, first).uint8(here);
        return here;
    }

    private int endOf(int first) {
        return Math.min(ranges.length, first + MOST_IN_A_PACKET);
    }
}
