package majic.pioneer.state;

import majic.bot.Pose;

/**
 * The offset between odometry and the pose that users see. Setting the pose changes the offset and never the odometry, so
 * that a motion in progress is not disturbed. The robot's own SETO is not used for it: it can only set zero and is not
 * confirmed, so that one SIP would look like a jump (ARCOS sheet 9.2). Thread-safe.
 */
public final class PoseOffset {
    private volatile Shift shift = new Shift(Pose.START, Pose.START);

    /** A pose of the odometry and the pose that it is reported as. */
    private record Shift(Pose odometry, Pose shown) {}

    /** The pose that a pose of the odometry is reported as. */
    public Pose of(Pose odometry) {
        Shift now = shift;
        double turn = Math.toRadians(now.shown.headingDeg() - now.odometry.headingDeg());
        double dx = odometry.xMm() - now.odometry.xMm();
        double dy = odometry.yMm() - now.odometry.yMm();
        return new Pose(
                now.shown.xMm() + dx * Math.cos(turn) - dy * Math.sin(turn),
                now.shown.yMm() + dx * Math.sin(turn) + dy * Math.cos(turn),
                odometry.headingDeg() + now.shown.headingDeg() - now.odometry.headingDeg());
    }

    /** Reports this pose of the odometry as another from now on. */
    public void put(Pose odometry, Pose shown) {
        shift = new Shift(odometry, shown);
    }
}
