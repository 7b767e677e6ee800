import java.io.IOException;
import java.nio.file.Path;
import majic.bot.MajicBot;
import majic.nav.CurrentMap;
import majic.ros.MajicRos;

/** Builds a map of a room with the laser scanner of a robot that speaks ROS, without window, team or script. */
public final class BuildMap {
    private BuildMap() {}

    /**
     * Drives a square and writes the map.
     *
     * @param args the robot's address, for instance {@code ros://localhost}, and the file of the map
     * @throws IOException if the map cannot be written
     */
    public static void main(String[] args) throws IOException {
        if (args.length != 2) {
            System.err.println("usage: BuildMap ADDRESS FILE, such as ros://localhost room.yaml");
            return;
        }
        try (MajicRos robot = new MajicRos(args[0])) {
            robot.connect();
            build(robot).save(Path.of(args[1]));
        }
    }

    private static CurrentMap build(MajicBot robot) {
        CurrentMap map = new CurrentMap((bot, news) -> System.out.println(bot.name() + " " + news));
        map.start(robot);
        for (int side = 0; side < 4; side++) {
            robot.move(500);
            robot.turn(90);
        }
        map.stop();
        System.out.println(map.text());
        return map;
    }
}
