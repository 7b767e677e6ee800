import java.util.List;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.mavlink.MajicMavlink;

/** Drives a rover that speaks MAVLink around a corner, without window, team or script. */
public final class RoverDrive {
    private RoverDrive() {}

    /**
     * Arms the rover, drives, turns, drives and disarms it; prints where on the earth it was in between.
     *
     * @param args the rover's address, for instance {@code mavlink:udp://:14550}
     */
    public static void main(String[] args) {
        if (args.length != 1) {
            System.err.println("usage: RoverDrive ADDRESS, such as mavlink:udp://:14550");
            return;
        }
        try (MajicMavlink rover = new MajicMavlink(args[0])) {
            rover.connect();
            drive(rover);
        } catch (BotException e) {
            System.err.println(args[0] + ": " + e.getMessage());
            System.exit(1);
        }
    }

    private static void drive(MajicBot rover) {
        rover.run("arm", List.of());
        printPlace(rover);
        rover.move(1500);
        rover.turn(90);
        rover.move(500);
        printPlace(rover);
        rover.run("disarm", List.of());
    }

    private static void printPlace(MajicBot rover) {
        System.out.println(rover.get("latitude") + " " + rover.get("longitude"));
    }
}
