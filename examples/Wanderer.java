import majic.pioneer.MajicPioneer;

/** A Pioneer that wanders by its sonars: ahead until something is near, then to the side with more room. */
public final class Wanderer {
    private Wanderer() {}

    /**
     * Drives a number of legs.
     *
     * @param args where the robot is, for instance {@code pioneer://localhost}, and how many legs
     */
    public static void main(String[] args) {
        if (args.length != 2) {
            System.err.println("usage: Wanderer ADDRESS LEGS, such as pioneer://localhost 5");
            return;
        }
        try (MajicPioneer robot = new MajicPioneer(args[0])) {
            robot.connect();
            for (int leg = Integer.parseInt(args[1]); leg > 0; leg--) {
                System.out.println("ahead "
                        + robot.move(2000, () -> robot.get("distanceFront").number() < 500));
                double left = robot.get("distanceLeft").number();
                double right = robot.get("distanceRight").number();
                System.out.println("turned " + robot.turn(left > right ? 100 : -100));
            }
        }
    }
}
