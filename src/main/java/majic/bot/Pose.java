package majic.bot;

/**
 * The position that a robot reports: x ahead of its start, y to the left of it. Immutable.
 *
 * @param xMm ahead of where it started, mm
 * @param yMm to the left of where it started, mm
 * @param headingDeg counterclockwise positive, −180 (excluded) to 180
 */
public record Pose(double xMm, double yMm, double headingDeg) {
    /** The pose of every robot at its start. */
    public static final Pose START = new Pose(0, 0, 0);

    /** Refuses what is not finite and brings the heading into its range. */
    public Pose {
        if (!Double.isFinite(xMm) || !Double.isFinite(yMm) || !Double.isFinite(headingDeg)) {
            throw new IllegalArgumentException("a pose is finite: " + xMm + ", " + yMm + ", " + headingDeg);
        }
        headingDeg = normalised(headingDeg);
    }

    /**
     * An angle brought to one turn.
     *
     * @param degrees finite
     * @return the same direction, −180 (excluded) to 180
     */
    public static double normalised(double degrees) {
        double rest = degrees % 360;
        if (rest > 180) {
            return rest - 360;
        }
        return rest <= -180 ? rest + 360 : rest;
    }

    /**
     * Returns the pose after a small motion along a circular arc.
     *
     * @param forwardMm the way along the arc, mm, ahead positive
     * @param turnDeg the turn on that way, counterclockwise positive
     * @return the new pose
     */
    public Pose after(double forwardMm, double turnDeg) {
        double middle = Math.toRadians(headingDeg + turnDeg / 2);
        double half = Math.toRadians(turnDeg / 2);
        double chord = Math.abs(half) < 1e-9 ? forwardMm : forwardMm * Math.sin(half) / half;
        return new Pose(xMm + chord * Math.cos(middle), yMm + chord * Math.sin(middle), headingDeg + turnDeg);
    }

    /**
     * Returns the straight distance to another pose.
     *
     * @param other in the same frame
     * @return mm
     */
    public double distanceMm(Pose other) {
        return Math.hypot(other.xMm - xMm, other.yMm - yMm);
    }

    /**
     * Returns how far ahead of this pose a place is, along its heading.
     *
     * @param place in the same frame
     * @return mm; negative for a place behind
     */
    public double aheadMm(Pose place) {
        double heading = Math.toRadians(headingDeg);
        return (place.xMm - xMm) * Math.cos(heading) + (place.yMm - yMm) * Math.sin(heading);
    }

    /**
     * Converts a pose relative to this one into the frame in which this one is given.
     *
     * @param relative for instance what a robot reports, from where it was added
     * @return the same place, seen from the origin of this pose
     */
    public Pose plus(Pose relative) {
        double angle = Math.toRadians(headingDeg);
        double x = xMm + relative.xMm * Math.cos(angle) - relative.yMm * Math.sin(angle);
        double y = yMm + relative.xMm * Math.sin(angle) + relative.yMm * Math.cos(angle);
        return new Pose(x, y, headingDeg + relative.headingDeg);
    }

    /**
     * Returns the origin of the frame in which this place is the given relative pose.
     *
     * @param relative this place in the frame that is looked for
     * @return the pose for which {@code plus(relative)} is this one
     */
    public Pose originOf(Pose relative) {
        Pose turned = new Pose(0, 0, headingDeg - relative.headingDeg);
        Pose offset = turned.plus(relative);
        return new Pose(xMm - offset.xMm, yMm - offset.yMm, turned.headingDeg);
    }

    /**
     * Returns this pose in the frame of another one.
     *
     * @param from the pose that is the origin of the new frame
     * @return the pose for which {@code from.plus(result)} is this one
     */
    public Pose seenFrom(Pose from) {
        return START.originOf(from).plus(this);
    }
}
