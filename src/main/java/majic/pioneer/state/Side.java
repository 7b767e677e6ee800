package majic.pioneer.state;

import majic.bot.Pose;

/** The four sides of a robot, each with the sonar discs that cover it. */
public enum Side {
    /** Ahead. */
    FRONT("distanceFront", 0, 50),
    /** To the left. */
    LEFT("distanceLeft", 90, 20),
    /** To the rear. */
    BACK("distanceBack", 180, 50),
    /** To the right. */
    RIGHT("distanceRight", -90, 20);

    /** By how much the hull may recede at rounded corners, mm. */
    private static final double CORNER_MM = 60;

    private final String parameter;
    private final double directionDeg;
    private final double sectorDeg;

    Side(String parameter, double directionDeg, double sectorDeg) {
        this.parameter = parameter;
        this.directionDeg = directionDeg;
        this.sectorDeg = sectorDeg;
    }

    /** The name of the parameter for the distance on this side. */
    public String parameter() {
        return parameter;
    }

    /** The description of the parameter. */
    public String help() {
        return switch (this) {
            case FRONT, BACK -> "from the hull to the nearest thing in the corridor it needs to drive and turn in";
            case LEFT, RIGHT -> "from the hull to the nearest thing beside it";
        };
    }

    /** Whether a disc must have had a reading before the distance on this side is known. */
    public boolean isCoveredBy(SonarDisc disc) {
        return Math.abs(Pose.normalised(disc.axisDeg() - directionDeg)) <= sectorDeg;
    }

    /**
     * The distance from the hull to a point that is an obstacle on this side. In front and behind, obstacles are all
     * points in the path that the robot needs to drive and turn on the spot; left and right, those level with the hull.
     *
     * @param x of the point in the robot's frame, mm
     * @param y of the point in the robot's frame, mm
     * @param margin added to the width of the path on either side, mm
     * @return mm, not negative; infinite for a point that is no obstacle
     */
    double gapMm(Hull hull, double x, double y, double margin) {
        return switch (this) {
            case FRONT -> gap(x - hull.frontMm(), Math.abs(y), hull.swingMm() + margin);
            case BACK -> gap(-x - hull.rearMm(), Math.abs(y), hull.swingMm() + margin);
            case LEFT -> gap(y - hull.halfWidthMm(), off(hull, x), margin);
            case RIGHT -> gap(-y - hull.halfWidthMm(), off(hull, x), margin);
        };
    }

    /** The distance in front of the front or behind the rear, mm; negative beside the hull. */
    private static double off(Hull hull, double x) {
        return Math.max(x - hull.frontMm(), -x - hull.rearMm());
    }

    /** A point a little behind the edge of the hull may be right in front of a rounded corner. */
    private static double gap(double ahead, double aside, double halfWidth) {
        boolean inTheWay = ahead > -CORNER_MM && aside <= halfWidth;
        return inTheWay ? Math.max(0, ahead) : Double.POSITIVE_INFINITY;
    }
}
