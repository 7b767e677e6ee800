import majic.bot.BotException;
import majic.pioneer.MajicPioneer;

/** Moves a Pioneer without window, team or script. */
public final class TenLines {
    private TenLines() {}

    /**
     * Drives round a corner and prints the distance ahead.
     *
     * @param args the robot's address, for instance {@code pioneer://localhost}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: TenLines ADDRESS, such as pioneer://localhost");
            return;
        }
        try (MajicPioneer robot = new MajicPioneer(args[0])) {
            robot.connect();
            robot.move(300);
            robot.turn(90);
            System.out.println("ahead: " + robot.get("distanceFront"));
        } catch (BotException e) {
            System.err.println(args[0] + ": " + e.getMessage());
            System.exit(1);
        }
    }
}
