package majicsim.pioneer.report;

import majicsim.pioneer.board.Board;
import majicsim.pioneer.model.Scaling;
import majicsim.pioneer.motion.Drive;

/**
 * The part of a SIP with pose and speed, in raw units (ARCOS sheet 8).
 *
 * @param x odometry; the counter's low 16 bits go on the wire
 * @param y odometry; as x
 * @param heading 4096ths of a turn, -2048 to 2047
 * @param leftSpeed of the left wheel
 * @param rightSpeed of the right wheel
 * @param control the heading servo's set-point, as the heading
 * @param turnRate in 0.1 deg/s
 */
record SipMotion(int x, int y, int heading, int leftSpeed, int rightSpeed, int control, int turnRate) {
    static SipMotion of(Board board) {
        Drive drive = board.drive();
        Scaling scaling = board.model().scaling();
        double aside = scaling.wheelMmPerSec(drive.turnDegPerSec());
        return new SipMotion(
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
