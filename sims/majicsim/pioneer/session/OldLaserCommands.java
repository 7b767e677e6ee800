package majicsim.pioneer.session;

/**
 * The vendor's client still requests the simulated laser by the numbers of a much older simulator, 36, 37, 38 and then
 * 35 (ARCOS sheet 6.2), which the robot uses for its gripper and its analog port. Three in that order, the second with
 * an angle that no gripper request has, are for the laser; all others are for the robot. A client that has sent them
 * once means the laser by these numbers for the rest of its session.
 */
final class OldLaserCommands {
    private static final int ENABLE = 35;
    private static final int START = 36;
    private static final int END = 37;
    private static final int STEP = 38;
    private static final int HIGHEST_GRIPPER_REQUEST = 2;

    private final SimLaser laser;
    private boolean known;
    private int awaited = START;
    private int startDeg;
    private int endDeg;

    OldLaserCommands(SimLaser laser) {
        this.laser = laser;
    }

    /** Executes a command if it is for the laser; returns false if it is for the robot. */
    boolean take(int id, int value) {
        if (known && id >= ENABLE && id <= STEP) {
            apply(id, value);
            return true;
        }
        boolean taken = id == awaited && fits(id, value);
        if (taken) {
            remember(id, value);
        }
        awaited = taken ? id + 1 : START;
        return taken && id != START;
    }

    private static boolean fits(int id, int value) {
        return id != END || Math.abs(value) > HIGHEST_GRIPPER_REQUEST;
    }

    private void remember(int id, int value) {
        switch (id) {
            case START -> startDeg = value;
            case END -> endDeg = value;
            default -> {
                known = true;
                laser.from(startDeg);
                laser.to(endDeg);
                laser.every(value);
            }
        }
    }

    private void apply(int id, int value) {
        switch (id) {
            case ENABLE -> laser.enable(value);
            case START -> laser.from(value);
            case END -> laser.to(value);
            default -> laser.every(value);
        }
    }
}
