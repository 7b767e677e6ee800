package majicsim.pioneer.session;

import java.util.List;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.ranging.LaserScan;
import majicsim.pioneer.report.LaserReport;

/** The simulated laser with the settings of one client (ARCOS sheet 6.2): off at first. */
final class SimLaser {
    private static final int OFF = 0;
    private static final int WITH_REFLECTANCE = 2;

    private final Board board;
    private LaserScan scan = LaserScan.USUAL;
    private int mode = OFF;

    SimLaser(Board board) {
        this.board = board;
    }

    /** SIM_LRF_ENABLE: 0 off, 1 packets 0x60, 2 packets 0x61. */
    void enable(int newMode) {
        mode = newMode;
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
}
