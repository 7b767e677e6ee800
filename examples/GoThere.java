import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.nav.Destination;
import majic.nav.Navigator;
import majic.pioneer.MajicPioneer;

/** Sends a Pioneer to a place and back, around what its sonars see, without window, team or script. */
public final class GoThere {
    private GoThere() {}

    /**
     * Drives a metre away and back, and prints the places.
     *
     * @param args the robot's address, for instance {@code pioneer://localhost}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: GoThere ADDRESS, such as pioneer://localhost");
            return;
        }
        try (MajicPioneer robot = new MajicPioneer(args[0])) {
            robot.connect();
            drive(robot);
        } catch (BotException e) {
            System.err.println(args[0] + ": " + e.getMessage());
            System.exit(1);
        }
    }

    private static MotionReport drive(MajicBot robot) {
        Navigator navigator = new Navigator();
        MotionReport there = navigator.goTo(robot, new Destination(800, 600));
        System.out.println("there: " + there);
        return navigator.goTo(robot, new Destination(0, 0));
    }
}
