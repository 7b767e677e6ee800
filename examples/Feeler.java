import majic.hemisson.MajicHemisson;

/** Moves a Hemisson without window, team or script. */
public final class Feeler {
    private Feeler() {}

    /**
     * Drives ahead until an obstacle is near, turns away and prints the readings.
     *
     * @param args the robot's address, for instance {@code hemisson:/dev/ttyUSB0}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: Feeler ADDRESS, such as hemisson:/dev/ttyUSB0");
            return;
        }
        try (MajicHemisson robot = new MajicHemisson(args[0])) {
            robot.connect();
            robot.move(200, () -> robot.get("distanceFront").number() < 40);
            robot.turn(90);
            System.out.println("ahead: " + robot.get("distanceFront") + ", ground: " + robot.get("groundLeft"));
        }
    }
}
