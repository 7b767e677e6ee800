package majic.pictures;

import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.gui.WindowWait;
import majic.gui.map.MapFeed;
import majic.gui.map.MapScene;
import majic.gui.map.TeamMap;
import majic.inlab.LabRig;
import majic.nav.Navigator;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;

/**
 * Makes the pictures of the team map while a robot builds a map of the lab's office, while two drive to places of it,
 * and with waypoints, on a stepped clock: {@code mvn -Pscreenshots test}, on a machine with a display.
 */
class MapPictures {
    private static final double STEP_MM = 600;
    private static final double NEAR_MM = 50;
    private static final double[][] WAY = {
        {-5000, -6300}, {-5000, -3500}, {-5000, -6300}, {0, -6300}, {0, -4300}, {0, -6300}, {5000, -6300}, {5000, -3800}
    };

    private final List<TeamMap> maps = new CopyOnWriteArrayList<>();
    private volatile MapScene shown = MapScene.EMPTY;

    @Test
    void paintsTheMapThatARobotBuilds() throws Exception {
        try (LabRig lab = LabRig.of(office());
                MapFeed feed = new MapFeed(
                        lab.team(), lab.session().factory(), lab.session().map(), this::show)) {
            JFrame large = PanelPicture.open(this::map, new Dimension(900, 620), false);
            JFrame small = PanelPicture.open(this::map, new Dimension(450, 320), true);
            feed.start();
            MajicBot robot = lab.add("pioneer");
            MajicBot other = lab.add("pioneer2");
            lab.run("1 set pose -9200 -6300 0", "2 set pose 9200 6300 180", "map start 1");
            for (double[] point : WAY) {
                drive(lab, robot, new Pose(point[0], point[1], 0));
            }
            move(other, 6000);
            lab.run("map place desk -6400 -1600 180", "wait 1s");
            PanelPicture.save(large, false, "map.png");
            PanelPicture.save(small, true, "map-small.png");
        }
    }

    @Test
    void paintsTwoRobotsOnTheirWay() throws Exception {
        try (LabRig lab = LabRig.of(office());
                MapFeed feed = new MapFeed(
                        lab.team(), lab.session().factory(), lab.session().map(), this::show)) {
            JFrame large = PanelPicture.open(this::map, new Dimension(900, 620), false);
            feed.start();
            lab.add("pioneer");
            lab.add("pioneer2");
            lab.run(
                    "map open sims/worlds/office.map",
                    "map place desk -6400 -1600 180",
                    "lab place 1 -5000 -6500 90",
                    "lab place 2 -6400 -3000 -90");
            lab.say("1 goto desk");
            lab.say("2 goto 3500 -2000 90");
            Navigator navigator = lab.session().map().navigator();
            boolean waits = lab.await(() -> lab.team().members().stream()
                    .anyMatch(member -> navigator.waits(member.bot()).isPresent()));
            Assertions.assertTrue(waits);
            PanelPicture.save(large, false, "going.png");
        }
    }

    @Test
    void paintsWaypointsThatAreDrawn() throws Exception {
        try (LabRig lab = LabRig.of(office());
                MapFeed feed = new MapFeed(
                        lab.team(), lab.session().factory(), lab.session().map(), this::show)) {
            JFrame large = PanelPicture.open(this::map, new Dimension(900, 620), false);
            feed.start();
            lab.add("pioneer");
            lab.run("map open sims/worlds/office.map", "map place desk -6400 -1600 180", "lab place 1 -9200 -6300 0");
            TeamMap map = maps.get(0);
            WindowWait.await(
                    "the place on the map",
                    () -> shown.map() != null && shown.robots().size() == 1);
            SwingUtilities.invokeAndWait(() -> {
                map.useWaypoints(script -> {}, error -> {});
                map.drawWaypoints();
                drag(map, new Pose(-9000, -3000, 0), new Pose(-9000, -3000, 0));
                drag(map, new Pose(-3000, 3600, 0), new Pose(-3000, 4600, 0));
                drag(map, new Pose(-6400, -1600, 0), new Pose(-6400, -1600, 0));
            });
            PanelPicture.save(large, false, "waypoints.png");
        }
    }

    private static void drag(TeamMap map, Pose from, Pose to) {
        send(map, MouseEvent.MOUSE_PRESSED, from);
        send(map, MouseEvent.MOUSE_RELEASED, to);
    }

    private static void send(TeamMap map, int id, Pose at) {
        Point2D pixel = map.view().pixel(at.xMm(), at.yMm());
        int x = (int) Math.round(pixel.getX());
        int y = (int) Math.round(pixel.getY());
        map.dispatchEvent(new MouseEvent(map, id, 0, InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1));
    }

    private static LabOptions office() throws IOException {
        return LabOptions.exactOnFreePorts()
                .withRoom(Room.load(Path.of("sims", "worlds", "office.map")))
                .withPioneer("p3dx-sh+laser")
                .withPioneers(2)
                .withNoise(7);
    }

    private TeamMap map() {
        TeamMap map = new TeamMap();
        maps.add(map);
        return map;
    }

    private void show(MapScene scene) {
        maps.forEach(map -> map.show(scene));
        shown = scene;
    }

    /** Turns twice, since the wheels of the lab turn a little too far or not far enough. */
    private void drive(LabRig lab, MajicBot robot, Pose goal) {
        for (int turn = 0; turn < 2; turn++) {
            Pose seen = goal.seenFrom(lab.truePose("pioneer"));
            robot.turn(Math.toDegrees(Math.atan2(seen.yMm(), seen.xMm())));
        }
        move(robot, goal.distanceMm(lab.truePose("pioneer")));
    }

    /** Moves in steps that the trail has as one line: the stepped clock is faster than the map. */
    private void move(MajicBot robot, double mm) {
        for (double left = mm; left > 0; left -= STEP_MM) {
            robot.move(Math.min(left, STEP_MM));
            Pose here = robot.state().pose();
            WindowWait.await(
                    "the robot on the map",
                    () -> shown.robots().stream().anyMatch(on -> on.reported().distanceMm(here) < NEAR_MM));
        }
    }
}
