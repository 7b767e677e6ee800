import majic.bot.MajicBot;
import majic.bot.RangeScan;
import majic.ros.MajicRos;

/** Prints what the laser scanner of a robot that speaks ROS measures, without window, team or script. */
public final class PrintScans {
    private PrintScans() {}

    /**
     * Drives a short way and prints each scan with the pose at which it was measured.
     *
     * @param args the robot's address, for instance {@code ros://localhost}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: PrintScans ADDRESS, such as ros://localhost");
            return;
        }
        try (MajicRos robot = new MajicRos(args[0])) {
            robot.connect();
            print(robot);
        }
    }

    private static void print(MajicBot robot) {
        robot.addScanListener(scan -> System.out.println(scan.sensor().name() + " at " + scan.odometry()
                + ": the nearest echo is at " + nearestMm(scan) + " mm"));
        robot.move(200);
    }

    private static float nearestMm(RangeScan scan) {
        float nearest = Float.POSITIVE_INFINITY;
        for (int beam = 0; beam < scan.size(); beam++) {
            if (scan.rangeMm(beam) < nearest) { // false for NaN: nothing was measured
                nearest = scan.rangeMm(beam);
            }
        }
        return nearest;
    }
}
