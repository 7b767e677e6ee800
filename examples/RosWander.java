import majic.bot.MajicBot;
import majic.ros.MajicRos;

/** Lets a robot that speaks ROS wander by its laser scanner, without window, team or script. */
public final class RosWander {
    private RosWander() {}

    /**
     * Drives ahead until an obstacle is near, then turns, five times.
     *
     * @param args the robot's address, for instance {@code ros://localhost}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: RosWander ADDRESS, such as ros://localhost");
            return;
        }
        try (MajicRos robot = new MajicRos(args[0])) {
            robot.connect();
            wander(robot);
        }
    }

    private static void wander(MajicBot robot) {
        for (int leg = 0; leg < 5; leg++) {
            robot.move(1000, () -> robot.get("distanceFront").number() < 400);
            robot.turn(100);
        }
    }
}
