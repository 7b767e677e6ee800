package majic.ros.readings;

import majic.ros.message.Vector;

/** The four sides of a robot, and which way is free on each. */
public enum HullSide {
    /** Ahead. */
    FRONT("distanceFront", 1, 0, 30, "from the hull to the nearest thing in its way ahead"),
    /** To the left. */
    LEFT("distanceLeft", 0, 1, 20, "from the hull to the nearest thing beside it on the left"),
    /** Backward. */
    BACK("distanceBack", -1, 0, 30, "from the hull to the nearest thing in its way backward"),
    /** To the right. */
    RIGHT("distanceRight", 0, -1, 20, "from the hull to the nearest thing beside it on the right");

    /** How far beside the hull something still counts, mm: odometry and mountings are not exact. */
    private static final double MARGIN_MM = 20;

    private final String parameter;
    private final int ahead;
    private final int left;
    private final double sectorDeg;
    private final String help;

    HullSide(String parameter, int ahead, int left, double sectorDeg, String help) {
        this.parameter = parameter;
        this.ahead = ahead;
        this.left = left;
        this.sectorDeg = sectorDeg;
        this.help = help;
    }

    /**
     * Returns the name of the parameter for the distance on this side.
     *
     * @return such as {@code distanceFront}
     */
    public String parameter() {
        return parameter;
    }

    /**
     * Returns the description of the parameter.
     *
     * @return one line
     */
    public String help() {
        return help;
    }

    /** Returns whether a sensor that points in a direction measures on this side. */
    boolean isSeenIn(double directionDeg) {
        double axisDeg = Math.toDegrees(Math.atan2(left, ahead));
        return Math.abs(Math.IEEEremainder(directionDeg - axisDeg, 360)) <= sectorDeg;
    }

    /**
     * Returns how far a round hull can go to this side until it touches a point.
     *
     * @param radiusMm of the hull
     * @param xMm of the point, ahead of the turning centre
     * @param yMm of the point, to the left of it
     * @return mm, not negative; infinite for a point that is not in the way, or inside of the hull, where a sensor sees
     *     the robot itself
     */
    double gapMm(double radiusMm, double xMm, double yMm) {
        double along = xMm * ahead + yMm * left;
        double aside = Math.abs(xMm * left - yMm * ahead);
        double squareBeside = Math.max(0, radiusMm * radiusMm - aside * aside);
        boolean inside = xMm * xMm + yMm * yMm < (radiusMm - MARGIN_MM) * (radiusMm - MARGIN_MM);
        if (along <= 0 || aside > radiusMm + MARGIN_MM || inside) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(0, along - Math.sqrt(squareBeside));
    }

    /** Returns the distance on this side from a sensor to the edge of a round hull, mm; negative outside of it. */
    double toHullMm(double radiusMm, Vector sensorMm) {
        return radiusMm - (sensorMm.x() * ahead + sensorMm.y() * left);
    }
}
