import majic.pioneer.MajicPioneer;

/** Lets a Pioneer wander by its sonars: ahead until an obstacle is near, then to the side with more room. */
public final class Wanderer {
    private Wanderer() {}

    /**
     * Drives a number of stretches.
     *
     * @param args the robot's address, for instance {@code pioneer://localhost}, and how many legs
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
