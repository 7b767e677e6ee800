package majic.nav.localisation;

import majic.bot.Pose;

/**
 * The place of a robot without range sensors: from a known one on by its odometry, with an uncertainty that grows with
 * the way and the turns (propagation of a covariance; Siegwart and Nourbakhsh 2004, 5.2.4). Not thread-safe.
 */
public final class OdometryPlace {
    private Pose pose;
    private Pose odometry;
    private double xx;
    private double xy;
    private double yy;
    private double xt;
    private double yt;
    private double tt;

    /**
     * Begins at a place.
     *
     * @param pose on the map
     * @param odometry at that time
     * @param sigmaMm the standard deviation of the place in each direction
     * @param sigmaDeg the standard deviation of the heading
     */
    public OdometryPlace(Pose pose, Pose odometry, double sigmaMm, double sigmaDeg) {
        this.pose = pose;
        this.odometry = odometry;
        xx = sigmaMm * sigmaMm;
        yy = xx;
        tt = Math.pow(Math.toRadians(sigmaDeg), 2);
    }

    /** Adds a motion, from the odometry of the last call to this one. */
    public void moved(Pose to) {
        Pose step = to.seenFrom(odometry);
        odometry = to;
        double way = Math.hypot(step.xMm(), step.yMm());
        double angle = Math.toRadians(pose.headingDeg());
        double dx = step.xMm() * Math.cos(angle) - step.yMm() * Math.sin(angle);
        double dy = step.xMm() * Math.sin(angle) + step.yMm() * Math.cos(angle);
        pose = pose.plus(step);
        xx += -2 * dy * xt + dy * dy * tt;
        xy += dx * xt - dy * yt - dx * dy * tt;
        yy += 2 * dx * yt + dx * dx * tt;
        xt -= dy * tt;
        yt += dx * tt;
        double turn = Math.abs(step.headingDeg());
        tt += MotionModel.varianceRad2(way, turn);
        xx += MotionModel.varianceMm2(way, turn);
        yy += MotionModel.varianceMm2(way, turn);
    }

    /** Returns where the robot is now; always placed, as its uncertainty says all there is. */
    public PoseEstimate estimate() {
        return new PoseEstimate(pose, xx, xy, yy, Math.toDegrees(Math.sqrt(tt)), true);
    }
}
