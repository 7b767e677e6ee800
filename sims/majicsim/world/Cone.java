package majicsim.world;

/** The part of the floor that a sensor looks at. Immutable. */
public final class Cone {
    private final Pose axis;
    private final double lengthMm;
    private final double sideMm;
    private final Direction left;
    private final Direction right;

    /** A direction in the room, as a vector of length 1. */
    private record Direction(double x, double y) {
        static Direction of(double deg) {
            return new Direction(Math.cos(Math.toRadians(deg)), Math.sin(Math.toRadians(deg)));
        }
    }

    /**
     * A cone.
     *
     * @param axis the place of the sensor and its direction
     * @param halfDeg the angle from the axis to either side, above 0 and below 90
     * @param lengthMm how far the sensor sees, above 0
     */
    public Cone(Pose axis, double halfDeg, double lengthMm) {
        this.axis = axis;
        this.lengthMm = lengthMm;
        this.sideMm = lengthMm / Math.cos(Math.toRadians(halfDeg));
        this.left = Direction.of(axis.headingDeg() + halfDeg);
        this.right = Direction.of(axis.headingDeg() - halfDeg);
    }

    Point tip() {
        return new Point(axis.xMm(), axis.yMm());
    }

    /** A rectangle along the axes of the room with everything that the sensor sees. */
    Bounds bounds() {
        double x = axis.xMm();
        double y = axis.yMm();
        double leftX = x + sideMm * left.x;
        double leftY = y + sideMm * left.y;
        double rightX = x + sideMm * right.x;
        double rightY = y + sideMm * right.y;
        return new Bounds(
                Math.min(x, Math.min(leftX, rightX)) - Bounds.SLACK_MM,
                Math.min(y, Math.min(leftY, rightY)) - Bounds.SLACK_MM,
                Math.max(x, Math.max(leftX, rightX)) + Bounds.SLACK_MM,
                Math.max(y, Math.max(leftY, rightY)) + Bounds.SLACK_MM);
    }

    /** Whether a ray in the cone may meet the body; sometimes true although none does. */
    boolean mayMeet(Body body) {
        double farthest = body.reachMm() + Bounds.SLACK_MM;
        Pose place = body.pose();
        return beyondLeftMm(place.xMm(), place.yMm()) <= farthest
                && beyondRightMm(place.xMm(), place.yMm()) <= farthest
                && body.mayReach(axis.xMm(), axis.yMm(), lengthMm);
    }

    /** Whether a ray in the cone may meet the wall; as for a body. */
    boolean mayMeet(Segment wall) {
        boolean isLeft = beyondLeftMm(wall.x1(), wall.y1()) > Bounds.SLACK_MM
                && beyondLeftMm(wall.x2(), wall.y2()) > Bounds.SLACK_MM;
        boolean isRight = beyondRightMm(wall.x1(), wall.y1()) > Bounds.SLACK_MM
                && beyondRightMm(wall.x2(), wall.y2()) > Bounds.SLACK_MM;
        return !isLeft && !isRight;
    }

    private double beyondLeftMm(double x, double y) {
        return left.x * (y - axis.yMm()) - left.y * (x - axis.xMm());
    }

    private double beyondRightMm(double x, double y) {
        return right.y * (x - axis.xMm()) - right.x * (y - axis.yMm());
    }
}
