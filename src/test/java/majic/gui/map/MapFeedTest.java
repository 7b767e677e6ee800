package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.gui.ToyBot;
import majic.gui.ToyLab;
import majic.gui.ToyType;
import majic.inlab.LabRig;
import majic.nav.CurrentMap;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class MapFeedTest {
    private final BotFactory factory = new BotFactory(List.of(new ToyType(BotType.Reach.TCP)), Settings.inMemory());
    private final Team team = new Team(TimeSource.system());
    private final CurrentMap map = new CurrentMap((bot, news) -> {});
    private final MapFeed feed = new MapFeed(team, factory, map, scene -> {});

    @AfterEach
    void close() {
        team.close();
        feed.close();
    }

    @Test
    void aRobotOfTheLabIsPlacedWhereItReallyStarted() {
        ToyLab lab = new ToyLab();
        factory.useLab(lab);
        ToyBot bot = add("sim:toy");
        feed.scene();
        bot.at(new Pose(100, 0, 0), true);
        lab.place(new Pose(1003, 595, 91));
        MapScene.Robot robot = feed.scene().robots().get(0);
        assertThat(robot.reported().distanceMm(new Pose(1000, 600, 0))).isLessThan(1e-6);
        assertThat(robot.truth()).isEqualTo(new Pose(1003, 595, 91));
        assertThat(feed.scene().walls()).hasSize(4);
    }

    @Test
    void aPlacedRobotIsDrawnWhereItWasPlaced() {
        ToyBot bot = add("toy://one");
        feed.scene();
        bot.place(new Pose(2000, 1000, 90));
        bot.at(new Pose(100, 0, 0), true);
        MapScene scene = feed.scene();
        assertThat(scene.robots().get(0).reported().distanceMm(new Pose(2000, 1100, 90)))
                .isLessThan(1e-6);
        assertThat(scene.startsAreGuessed()).isFalse();
    }

    @Test
    void aPlacedRobotOfTheLabKeepsItsTruePose() {
        factory.useLab(new ToyLab());
        add("sim:toy").place(new Pose(10, 20, 0));
        MapScene.Robot robot = feed.scene().robots().get(0);
        assertThat(robot.reported()).isEqualTo(new Pose(10, 20, 0));
        assertThat(robot.truth()).isEqualTo(ToyLab.FIRST_PLACE);
        assertThat(feed.scene().bystanders()).isEmpty();
    }

    @Test
    void aRobotOfTheLabOutsideTheTeamIsDrawnToo() {
        factory.useLab(new ToyLab());
        assertThat(feed.scene().bystanders()).containsExactly(new MapScene.Bystander("toy", ToyLab.FIRST_PLACE));
        add("sim:toy");
        assertThat(feed.scene().bystanders()).isEmpty();
    }

    @Test
    void withoutALabRobotsAreDrawnSideBySide() {
        add("toy://one");
        add("toy://two");
        MapScene scene = feed.scene();
        assertThat(scene.startsAreGuessed()).isTrue();
        assertThat(scene.robots()).extracting(robot -> robot.reported().yMm()).containsExactly(0.0, -1000.0);
    }

    @Test
    void robotsWithAnUnknownPlaceAreDrawnBesideTheRoomOfTheLab() {
        add("toy://one");
        add("toy://two");
        feed.scene();
        factory.useLab(new ToyLab());
        MapScene scene = feed.scene();
        double right = scene.walls().stream()
                .mapToDouble(wall -> Math.max(wall.x1(), wall.x2()))
                .max()
                .orElseThrow();
        assertThat(scene.startsAreGuessed()).isTrue();
        assertThat(scene.robots())
                .allSatisfy(robot ->
                        assertThat(robot.reported().xMm() - robot.bodyMm()).isGreaterThan(right));
        assertThat(scene.robots().get(0).reported())
                .isNotEqualTo(scene.robots().get(1).reported());
    }

    @Test
    void theTrailRemembersTheWay() {
        ToyBot bot = add("toy://one");
        feed.scene();
        bot.at(new Pose(50, 0, 0), true);
        feed.scene();
        bot.at(new Pose(55, 0, 0), true);

        Rectangle2D extent = new Rectangle2D.Double();
        feed.scene().robots().get(0).trail().extend(extent);
        assertThat(Math.hypot(extent.getWidth(), extent.getHeight())).isEqualTo(50);
    }

    @Test
    void aRobotUnderWayHasItsWayFromWhereItIsDrawn() throws InterruptedException {
        try (LabRig rig = LabRig.exact();
                MapFeed ofLab = new MapFeed(
                        rig.team(), rig.session().factory(), rig.session().map(), scene -> {})) {
            MajicBot robot = rig.add("pioneer");
            Pose place = rig.truePose("pioneer").plus(new Pose(500, 0, 0));
            assertThat(ofLab.scene().robots().get(0).way()).isEqualTo(MapScene.PlannedWay.NONE);

            rig.say("1 goto 500 0");
            rig.await(() -> robot.state().moving());

            List<Pose> corners = ofLab.scene().robots().get(0).way().corners();
            assertThat(corners.get(corners.size() - 1).distanceMm(place)).isLessThan(1);
            assertThat(ofLab.scene().robots().get(0).way().reserved()).isNotEmpty();
        }
    }

    @Test
    void aCopterHasItsHeightAndARoverHasNone() throws InterruptedException {
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready,rover+ready");
                MapFeed ofLab = new MapFeed(
                        rig.team(), rig.session().factory(), rig.session().map(), scene -> {})) {
            rig.add("mavlink");
            rig.add("mavlink2");
            rig.lab().time().sleep(2);
            rig.run("1 set fence 5000 500 5000", "1 arm", "1 takeoff 2000", "1 wait");

            assertThat(ofLab.scene().robots().get(0).heightMm()).isBetween(1700.0, 2300.0);
            assertThat(rig.team().member(2).bot().get("altitude").number()).isFinite();
            assertThat(rig.team().member(2).bot().heightMm()).isEmpty();
        }
    }

    @Test
    void anUnchangedTeamMakesAnEqualScene() {
        add("toy://one");
        assertThat(feed.scene()).isEqualTo(feed.scene());
    }

    private ToyBot add(String address) {
        ToyBot bot = (ToyBot) factory.create(address);
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }
}
