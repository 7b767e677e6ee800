package majicsim.pioneer.motion;

import majicsim.world.Pose;

/** The heading set-point of HEAD, DHEAD and DCHEAD, in degrees of odometry. */
final class HeadingServo {
    private boolean active;
    private double setPointDeg;

    /** Turns the channel to a heading by the shorter turn, unless it turns there already. */
    void head(Channel rotation, double presentDeg, double wantedDeg) {
        double wanted = Pose.normalised(wantedDeg);
        if (rotation.isInEmergency() || active && wanted == setPointDeg) {
            return;
        }
        rotation.follow(new Goal.Position(rotation.position() + Pose.normalised(wanted - presentDeg)));
        active = true;
        setPointDeg = wanted;
    }

    /** Ends the set-point, because the rotation channel has another command. */
    void release() {
        active = false;
    }

    /** Adapts to a change of the odometry's heading; the true target direction stays. */
    void shift(double degrees) {
        setPointDeg = Pose.normalised(setPointDeg + degrees);
    }

    boolean isActive() {
        return active;
    }

    double setPointDeg() {
        return setPointDeg;
    }
}
