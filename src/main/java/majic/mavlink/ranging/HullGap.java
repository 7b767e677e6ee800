package majic.mavlink.ranging;

/** The sides of a vehicle on which its distances to things count. */
public enum HullGap {
    /** Ahead. */
    FRONT("distanceFront", 0, 30, "from the hull to the nearest thing ahead"),
    /** To the left. */
    LEFT("distanceLeft", 90, 45, "from the hull to the nearest thing on the left"),
    /** Backward. */
    BACK("distanceBack", 180, 30, "from the hull to the nearest thing behind"),
    /** To the right. */
    RIGHT("distanceRight", -90, 45, "from the hull to the nearest thing on the right");

    private final String parameter;
    private final double directionDeg;
    private final double sectorDeg;
    private final String help;

    HullGap(String parameter, double directionDeg, double sectorDeg, String help) {
        this.parameter = parameter;
        this.directionDeg = directionDeg;
        this.sectorDeg = sectorDeg;
        this.help = help;
    }

    /** Returns the name of its parameter. */
    public String parameter() {
        return parameter;
    }

    /** Returns the description of its parameter. */
    public String help() {
        return help;
    }

    /** Returns whether a beam in a direction measures on this side. */
    boolean isSeenIn(double beamDeg) {
        return Math.abs(Math.IEEEremainder(beamDeg - directionDeg, 360)) <= sectorDeg;
    }
}
