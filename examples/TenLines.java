import majic.pioneer.MajicPioneer;

/** A Pioneer without window, team or script. */
public final class TenLines {
    private TenLines() {}

    /**
     * Drives a little square and tells what is ahead.
     *
     * @param args where the robot is, for instance {@code pioneer://localhost}
     */
    public static void main(String[] args) {
        try (MajicPioneer robot = new MajicPioneer(args[0])) {
            robot.connect();
            for (int side = 0; side < 4; side++) {
                robot.move(300);
                robot.turn(90);
            }
            System.out.println("ahead: " + robot.get("distanceFront"));
        }
    }
}
