package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.nav.Destination;
import majic.nav.grid.NavigationMap.Place;
import majic.panel.map.Trail;
import majic.script.ScriptAct;
import org.junit.jupiter.api.Test;

class WaypointTest {
    private static final List<Waypoint> WAY = List.of(
            new Waypoint(new Destination(1200.4, -0.3), ""),
            new Waypoint(new Destination(new Pose(0, 500, 90), true), ""),
            new Waypoint(new Destination(new Place("desk", new Pose(1, 2, 3), true)), "desk"));

    @Test
    void aScriptSendsTheRobotFromOneWaypointToTheNext() {
        assertThat(Waypoint.script(WAY, List.of(robot(2, Pose.START))).lines())
                .containsExactly("# Goes to 3 places of the map.", "2 goto 1200 0", "2 goto 0 500 90", "2 goto desk");
    }

    @Test
    void severalRobotsShareALine() {
        List<MapScene.Robot> robots = List.of(robot(1, Pose.START), robot(3, Pose.START));

        assertThat(Waypoint.script(WAY, robots).lines()).contains("1,3 goto 1200 0", "1,3 goto desk");
    }

    @Test
    void aRobotThatWasNotPlacedGetsThePlaceInItsOwnFrame() {
        List<MapScene.Robot> robots = List.of(robot(1, Pose.START), robot(2, new Pose(200, 0, 90)));

        assertThat(Waypoint.script(WAY, robots).lines())
                .containsExactly(
                        "# Goes to 3 places of the map.",
                        "1 goto 1200 0",
                        "2 goto 0 -1000",
                        "1 goto 0 500 90",
                        "2 goto 500 200 0",
                        "1,2 goto desk");
    }

    @Test
    void theScriptBecomesAnActOfAnyRobot() {
        ScriptAct act = new ScriptAct("way.majic", Waypoint.script(WAY, List.of(robot(2, Pose.START))));

        assertThat(act.roles()).hasSize(1);
        assertThat(act.description()).isEqualTo("Goes to 3 places of the map.");
    }

    private static MapScene.Robot robot(int number, Pose origin) {
        return new MapScene.Robot(
                number,
                "Toy",
                100,
                origin,
                origin,
                Uncertainty.UNKNOWN,
                null,
                new Trail(),
                true,
                false,
                MapScene.PlannedWay.NONE);
    }
}
