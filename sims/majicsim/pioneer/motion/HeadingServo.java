package majicsim.pioneer.motion;

import majicsim.world.Pose;

/** The heading set-point of HEAD, DHEAD and DCHEAD, in degrees of odometry. */
final class HeadingServo {
    private boolean active;
    private double setPointDeg;

    /** Turns the channel to a heading the shorter way round, unless it is on its way there already. */
    void head(Channel rotation, double presentDeg, double wantedDeg) {
        double wanted = Pose.normalised(wantedDeg);
        if (rotation.isInEmergency() || active && wanted == setPointDeg) {
            return;
        }
        rotation.aim(new Goal.Position(rotation.position() + Pose.normalised(wanted - presentDeg)));
        active = true;
        setPointDeg = wanted;
    }

    /** The rotation channel serves something else now. */
    void release() {
        active = false;
    }

    /** The odometry's heading was set anew by so much; the direction aimed at stays. */
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
