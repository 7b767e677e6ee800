package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.devices.Devices;

/**
 * The part of a SIP between motion and sonar: the robot's status (ARCOS sheet 8).
 *
 * @param batteryTenthVolts in 0.1 V
 * @param left bit 0 left motor stalled, bits 1 to 7 rear bumpers
 * @param right bit 0 right motor stalled, bits 1 to 7 front bumpers
 * @param flags as sheet 8.1
 * @param compass in units of 2 degrees, 0 for none
 */
record SipStatus(int batteryTenthVolts, int left, int right, int flags, int compass) {
    private static final int JOYSTICK_BUTTON = 1 << 9;
    private static final int CHARGER_POWER_GOOD = 1 << 10;

    static SipStatus of(Board board) {
        Devices devices = board.devices();
        int stall = board.reportStall() ? 1 : 0;
        return new SipStatus(
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
