import majic.bot.MajicBot;
import majic.hemisson.MajicHemisson;

/** Lets a Hemisson follow the left edge of a dark line until an obstacle is near. */
public final class LineFollower {
    private LineFollower() {}

    /**
     * Follows the line on which the robot stands.
     *
     * @param args the robot's address, for instance {@code hemisson:/dev/ttyUSB0}
     * @throws InterruptedException if it is interrupted meanwhile
     */
    public static void main(String[] args) throws InterruptedException {
        if (args.length != 1) {
            System.err.println("usage: LineFollower ADDRESS, such as hemisson:/dev/ttyUSB0");
            return;
        }
        try (MajicHemisson robot = new MajicHemisson(args[0])) {
            robot.connect();
            follow(robot);
        }
    }

    static void follow(MajicBot robot) throws InterruptedException {
        while (robot.get("distanceFront").number() > 40) {
            robot.drive(42, robot.get("groundRight").number() < 90 ? 30 : -30);
            robot.time().sleep(0.05);
        }
        robot.stop();
    }
}
