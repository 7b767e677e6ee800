package majicsim.world;

/**
 * Where a body truly is. Immutable.
 *
 * @param xMm millimetres along the room's x axis
 * @param yMm millimetres along the room's y axis
 * @param headingDeg degrees counter-clockwise from the x axis; any finite value is taken and kept as -180 (excluded) to
 *     180
 */
public record Pose(double xMm, double yMm, double headingDeg) {

    /**
     * Checks and normalises.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public Pose {
        if (!Double.isFinite(xMm) || !Double.isFinite(yMm) || !Double.isFinite(headingDeg)) {
            throw new IllegalArgumentException("a pose must be finite: " + xMm + ", " + yMm + ", " + headingDeg);
        }
        headingDeg = normalised(headingDeg);
    }

    /**
     * The same direction as an angle above -180 and not above 180.
     *
     * @param degrees any finite angle
     * @return the angle, normalised
     */
    public static double normalised(double degrees) {
        if (degrees > -180 && degrees <= 180) {
            return degrees;
        }
        double rest = Math.IEEEremainder(degrees, 360);
        return rest <= -180 ? rest + 360 : rest;
    }

    /**
     * A point of this body's frame as a point of the room.
     *
     * @param aheadMm millimetres ahead of the turning centre
     * @param leftMm millimetres to the left of it
     * @return the point in room coordinates
     */
    public Point toWorld(double aheadMm, double leftMm) {
        double angle = Math.toRadians(headingDeg);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        return new Point(xMm + aheadMm * cos - leftMm * sin, yMm + aheadMm * sin + leftMm * cos);
    }

    /**
     * A point of the room as seen from this body.
     *
     * @param point a point in room coordinates
     * @return millimetres ahead (x) and to the left (y)
     */
    public Point toLocal(Point point) {
        double angle = Math.toRadians(headingDeg);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double dx = point.xMm() - xMm;
        double dy = point.yMm() - yMm;
        return new Point(dx * cos + dy * sin, dy * cos - dx * sin);
    }

    /**
     * A direction of this body's frame as a direction of the room.
     *
     * @param directionDeg degrees counter-clockwise from straight ahead
     * @return degrees counter-clockwise from the room's x axis, normalised
     */
    public double toWorldDeg(double directionDeg) {
        return normalised(headingDeg + directionDeg);
    }

    /**
     * The pose after an arc of constant curvature; exact for any angle.
     *
     * @param aheadMm length of the arc, negative backward
     * @param turnDeg change of heading on the way, counter-clockwise positive
     * @return the new pose
     */
    public Pose driven(double aheadMm, double turnDeg) {
        double half = Math.toRadians(turnDeg) / 2;
        double chord = Math.abs(half) < 1e-9 ? aheadMm : aheadMm * Math.sin(half) / half;
        double along = Math.toRadians(headingDeg) + half;
        return new Pose(xMm + chord * Math.cos(along), yMm + chord * Math.sin(along), headingDeg + turnDeg);
    }

    /**
     * The distance to another pose, headings left out.
     *
     * @param other the other pose
     * @return millimetres, never negative
     */
    public double distanceTo(Pose other) {
        double dx = other.xMm - xMm;
        double dy = other.yMm - yMm;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
