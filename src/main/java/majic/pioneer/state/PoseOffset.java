package majic.pioneer.state;

import majic.bot.Pose;

/**
 * Where a person wants the robot to be said to stand. Setting the pose moves the frame in which poses are told and never
 * the odometry itself: motions under way measure on undisturbed. The robot's own SETO is not used for it, as it knows
 * nothing but zero and is never confirmed, so that one SIP would be taken for a jump (ARCOS sheet 9.2). Thread-safe.
 */
public final class PoseOffset {
    private volatile Shift shift = new Shift(Pose.START, Pose.START);

    /** What one pose of the odometry is to be called. */
    private record Shift(Pose odometry, Pose told) {}

    /** What a pose of the odometry is to be called. */
    public Pose of(Pose odometry) {
        Shift now = shift;
        double turn = Math.toRadians(now.told.headingDeg() - now.odometry.headingDeg());
        double dx = odometry.xMm() - now.odometry.xMm();
        double dy = odometry.yMm() - now.odometry.yMm();
        return new Pose(
                now.told.xMm() + dx * Math.cos(turn) - dy * Math.sin(turn),
                now.told.yMm() + dx * Math.sin(turn) + dy * Math.cos(turn),
                odometry.headingDeg() + now.told.headingDeg() - now.odometry.headingDeg());
    }

    /** Calls this pose of the odometry so from now on. */
    public void put(Pose odometry, Pose told) {
        shift = new Shift(odometry, told);
    }
}
