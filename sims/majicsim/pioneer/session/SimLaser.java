package majicsim.pioneer.session;

import java.util.List;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.ranging.LaserScan;
import majicsim.pioneer.report.LaserReport;

/**
 * The simulated laser with the settings of one client (ARCOS sheet 6.2): off at first, and always on a robot without
 * one.
 */
final class SimLaser {
    private static final int OFF = 0;
    private static final int WITH_REFLECTANCE = 2;

    private static final int OLD_ENABLE = 35;
    private static final int OLD_START = 36;
    private static final int OLD_END = 37;
    private static final int OLD_STEP = 38;
    private static final int HIGHEST_GRIPPER_REQUEST = 2;

    private final Board board;
    private LaserScan scan = LaserScan.USUAL;
    private int mode = OFF;
    private boolean usesOldNumbers;
    private int awaited = OLD_START;
    private int startDeg;
    private int endDeg;

    SimLaser(Board board) {
        this.board = board;
    }

    /** SIM_LRF_ENABLE: 0 off, 1 packets 0x60, 2 packets 0x61. */
    void enable(int newMode) {
        mode = isThere() ? newMode : OFF;
    }

    /** Whether the robot has one. */
    boolean isThere() {
        return board.model().equipment().hasLaser();
    }

    boolean isOn() {
        return mode != OFF;
    }

    /** SIM_LRF_SET_FOV_START. */
    void from(int degrees) {
        scan = scan.from(degrees);
    }

    /** SIM_LRF_SET_FOV_END. */
    void to(int degrees) {
        scan = scan.to(degrees);
    }

    /** SIM_LRF_SET_RES, in hundredths of a degree. */
    void every(int centidegrees) {
        scan = scan.every(Math.abs(centidegrees) / 100.0);
    }

    /** The packets of this cycle's scan; none while it is off. */
    List<byte[]> packets() {
        if (!isOn()) {
            return List.of();
        }
        LaserReport report =
                new LaserReport(board.drive().odometry(), board.laser().ranges(scan));
        return mode == WITH_REFLECTANCE ? report.withReflectance(board.wasLifted()) : report.withPose();
    }

    /**
     * Executes a command by an old number if it is for the laser; returns false if it is for the robot. The vendor's
     * client still requests the laser by the numbers of a much older simulator, 36, 37, 38 and then 35 (ARCOS sheet
     * 6.2), which the robot uses for its gripper and its analog port. Three in that order, the second with an angle
     * that no gripper request has, are for the laser; all others are for the robot. A client that has sent them once
     * means the laser by these numbers for the rest of its session.
     */
    boolean takeOld(int id, int value) {
        if (!isThere()) {
            return false;
        }
        if (usesOldNumbers && id >= OLD_ENABLE && id <= OLD_STEP) {
            apply(id, value);
            return true;
        }
        boolean taken = id == awaited && fits(id, value);
        if (taken) {
            remember(id, value);
        }
        awaited = taken ? id + 1 : OLD_START;
        return taken && id != OLD_START;
    }

    private static boolean fits(int id, int value) {
        return id != OLD_END || Math.abs(value) > HIGHEST_GRIPPER_REQUEST;
    }

    private void remember(int id, int value) {
        switch (id) {
            case OLD_START -> startDeg = value;
            case OLD_END -> endDeg = value;
            default -> {
                usesOldNumbers = true;
                from(startDeg);
                to(endDeg);
                every(value);
            }
        }
    }

    private void apply(int id, int value) {
        switch (id) {
            case OLD_ENABLE -> enable(value);
            case OLD_START -> from(value);
            case OLD_END -> to(value);
            default -> every(value);
        }
    }
}
