package majicsim.pioneer.report;

import java.util.List;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Devices;
import majicsim.pioneer.model.Scaling;
import majicsim.pioneer.motion.Drive;
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
record Sip(Motion motion, Status status, List<SonarReading> sonar, SipTail tail) {
    /**
     * The part with pose and speed, in raw units (ARCOS sheet 8).
     *
     * @param x odometry; the counter's low 16 bits go on the wire
     * @param y odometry; as x
     * @param heading 4096ths of a turn, -2048 to 2047
     * @param leftSpeed of the left wheel
     * @param rightSpeed of the right wheel
     * @param control the heading servo's set-point, as the heading
     * @param turnRate in 0.1 deg/s
     */
    record Motion(int x, int y, int heading, int leftSpeed, int rightSpeed, int control, int turnRate) {
        static Motion of(Board board) {
            Drive drive = board.drive();
            Scaling scaling = board.model().scaling();
            double aside = scaling.wheelMmPerSec(drive.turnDegPerSec());
            return new Motion(
                    scaling.position(drive.odometry().xMm()),
                    scaling.position(drive.odometry().yMm()),
                    scaling.heading(drive.odometry().headingDeg()),
                    scaling.speed(drive.speedMmPerSec() - aside),
                    scaling.speed(drive.speedMmPerSec() + aside),
                    scaling.heading(drive.headingSetPointDeg()),
                    (int) Math.round(drive.turnDegPerSec() * 10));
        }

        boolean isMoving() {
            return leftSpeed != 0 || rightSpeed != 0 || turnRate != 0;
        }
    }

    /**
     * The part between motion and sonar: the robot's status (ARCOS sheet 8).
     *
     * @param batteryTenthVolts in 0.1 V
     * @param left bit 0 left motor stalled, bits 1 to 7 rear bumpers
     * @param right bit 0 right motor stalled, bits 1 to 7 front bumpers
     * @param flags as sheet 8.1
     * @param compass in units of 2 degrees, 0 for none
     */
    record Status(int batteryTenthVolts, int left, int right, int flags, int compass) {
        private static final int JOYSTICK_BUTTON = 1 << 9;
        private static final int CHARGER_POWER_GOOD = 1 << 10;

        static Status of(Board board) {
            Devices devices = board.devices();
            int stall = board.reportStall() ? 1 : 0;
            return new Status(
                    devices.battery().tenthVolts(),
                    stall | board.bumpers().rear() << 1,
                    stall | board.bumpers().front() << 1,
                    flags(board, devices),
                    board.model().equipment().hasCompass()
                            ? devices.compass().reading(board.truePose().headingDeg())
                            : 0);
        }

        private static int flags(Board board, Devices devices) {
            return (board.drive().isEnabled() ? 1 : 0)
                    | board.sonar().arraysOn() << 1
                    | devices.stopButton().flags()
                    | devices.infrared().flags()
                    | (devices.joystick().isAnyButtonPressed() ? JOYSTICK_BUTTON : 0)
                    | (devices.charger().isPowerGood() ? CHARGER_POWER_GOOD : 0);
        }
    }

    private static final int STATIONARY = 0x32;
    private static final int MOVING = 0x33;

    /** The state now. Takes the sonar readings, which are reported only once. */
    static Sip of(Board board) {
        return new Sip(Motion.of(board), Status.of(board), board.sonar().takeFresh(), SipTail.of(board));
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
