package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.nav.Destination;
import majic.nav.Navigator;
import majic.nav.Wait;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A Pioneer with a laser that is sent to places of the office. */
class GoToInLabTest {
    private static final Path OFFICE = Path.of("sims", "worlds", "office.map");

    @AutoClose
    private final LabRig rig = LabRig.of(office());

    private final MajicBot robot = rig.add("pioneer");

    GoToInLabTest() throws InterruptedException {
        rig.run("map open " + OFFICE);
        robot.place(rig.truePose("pioneer"));
    }

    private static LabOptions office() {
        try {
            return LabOptions.exactOnFreePorts()
                    .withPioneer("p3dx-sh+laser")
                    .withPioneers(2)
                    .withRoom(Room.load(OFFICE));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private int contacts() {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
    }

    @Test
    void itDrivesAroundTheCornersToTheHeading() throws InterruptedException {
        String answer = rig.run("1 goto -3000 3600 90", "1 wait").get(1);

        assertThat(answer).matches(".*goto -3000 3600 90: done \\(-?\\d+ mm, -?\\d+ mm, -?[\\d.]+ deg; [\\d.]+ s\\)");
        Pose there = rig.truePose("pioneer");
        assertThat(there.distanceMm(new Pose(-3000, 3600, 0))).isLessThan(50);
        assertThat(there.headingDeg()).isBetween(85.0, 95.0);
        assertThat(contacts()).isZero();
    }

    @Test
    void itDrivesToAPlaceOfTheMap() throws InterruptedException {
        rig.run("map place door -9000 0");

        assertThat(rig.run("1 goto door")).last().asString().contains("goto door: done (");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(-9000, 0, 0))).isLessThan(50);
    }

    @Test
    void anUnknownPlaceIsRefusedWithThoseThatThereAre() throws InterruptedException {
        rig.run("map place door -9000 0");

        assertThat(rig.run("1 goto desk"))
                .last()
                .asString()
                .contains("desk: there is no such place on the map; there are door");
    }

    @Test
    void aPlaceInsideAWallIsRefusedAndTheRobotStands() throws InterruptedException {
        Pose before = rig.truePose("pioneer");

        assertThat(rig.run("1 goto -8000 0"))
                .last()
                .asString()
                .contains("goto -8000 0: failed: no way to -8000 0: it is inside a wall");
        assertThat(rig.truePose("pioneer").distanceMm(before)).isZero();
    }

    @Test
    void itDrivesAroundARobotThatOnlyItsLaserSees() throws InterruptedException {
        rig.run("lab place pioneer2 -6500 -6000 0");
        Pose other = rig.truePose("pioneer2");

        assertThat(rig.run("1 goto -4000 -6000")).last().asString().contains("done");
        assertThat(contacts()).isZero();
        assertThat(rig.truePose("pioneer2")).isEqualTo(other);
    }

    /** Neither is in the team of the other, so each knows of the other what its laser sees. */
    @Test
    void twoThatAreTooCloseToTurnDoNotTouchEachOther() throws InterruptedException {
        MajicBot other = rig.add("pioneer2");
        rig.run("lab place 1 -8180 -6259 -170", "lab place 2 -8713 -5956 -60");
        rig.lab().time().sleep(1);

        sentAlone(other, new Destination(-9300, -5956));
        CompletableFuture<String> arrived = sentAlone(robot, new Destination(-6500, -6259));

        assertThat(rig.await(arrived::isDone)).isTrue();
        assertThat(contacts()).isZero();
    }

    @Test
    void twoThatHaveNoRoomToTurnDriveApart() throws InterruptedException {
        MajicBot other = rig.add("pioneer2");
        rig.run("lab place 1 4554 -5824 -121", "lab place 2 3954 -5903 -54");
        rig.lab().time().sleep(1);

        CompletableFuture<String> first = sentAlone(robot, new Destination(6500, -3000));
        CompletableFuture<String> second = sentAlone(other, new Destination(935, -2463));

        assertThat(rig.await(() -> first.isDone() && second.isDone())).isTrue();
        assertThat(first).isCompleted();
        assertThat(second).isCompleted();
        assertThat(contacts()).isZero();
    }

    private CompletableFuture<String> sentAlone(MajicBot bot, Destination destination) {
        Navigator navigator = new Navigator(rig.session().map()::get);
        CompletableFuture<String> arrived = new CompletableFuture<>();
        rig.lab()
                .time()
                .thread(
                        bot.name(),
                        () -> arrived.completeAsync(
                                () -> navigator.goTo(bot, destination).toString(), Runnable::run))
                .start();
        return arrived;
    }

    @Test
    void itSaysWhyItWaitsUntilItIsStopped() throws InterruptedException {
        rig.add("pioneer2");
        rig.run("lab place 2 -5000 -4900 90");

        rig.say("1 goto -5000 -3500");
        Navigator navigator = rig.session().map().navigator();
        assertThat(rig.await(() -> navigator.waits(robot).isPresent())).isTrue();
        Wait wait = navigator.waits(robot).orElseThrow();
        assertThat(wait.why()).isEqualTo("robot 2 (Pioneer) stands in the way");
        assertThat(wait.other()).contains(rig.team().member(2).bot());
        rig.run("1 stop");
        assertThat(navigator.waits(robot)).isEmpty();
    }

    @Test
    void aStopEndsIt() throws InterruptedException {
        rig.say("1 goto 5000 -6000");
        rig.lab().time().sleep(5);
        rig.run("1 stop");

        rig.lab().time().sleep(2);
        Pose stood = rig.truePose("pioneer");
        rig.lab().time().sleep(2);
        assertThat(rig.truePose("pioneer").distanceMm(stood)).isZero();
        assertThat(stood.xMm()).isBetween(-9150.0, -6000.0);
        assertThat(rig.session().map().navigator().way(robot)).isEmpty();
    }

    @Test
    void aConditionEndsIt() throws InterruptedException {
        assertThat(rig.run("1 goto 5000 -6000 until x > -7000"))
                .last()
                .asString()
                .contains("done (");
        assertThat(rig.truePose("pioneer").xMm()).isBetween(-7100.0, -6600.0);
    }

    @Test
    void withoutItsPlaceItIsRefused() throws InterruptedException {
        robot.place(robot.state().pose(), Uncertainty.UNKNOWN);

        assertThat(rig.run("1 goto 5000 -6000"))
                .last()
                .asString()
                .contains("failed: its place on the map is not known");
    }

    @Test
    void withoutAMapItDrivesByItsOdometryAroundWhatItSees() throws InterruptedException {
        rig.run("map close");

        assertThat(rig.run("1 goto -6300 -5800")).last().asString().contains("done (");
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(-6300, -5800, 0)))
                .isLessThan(60);
        assertThat(contacts()).isZero();
    }

    /** Puts the second Pioneer somewhere, and into the team. */
    private void addOther(Pose place) throws InterruptedException {
        rig.lab().place("pioneer2", place);
        rig.lab().time().sleep(0.5);
        rig.add("pioneer2").place(rig.truePose("pioneer2"));
    }

    @Test
    void twoThatComeFromTheEndsOfACorridorPassEachOther() throws InterruptedException {
        addOther(new Pose(7000, -6000, 180));

        List<String> answers = rig.run("1 goto 7000 -6000", "2 goto -7000 -6000", "1,2 wait");

        assertThat(answers).filteredOn(answer -> answer.contains(": done (")).hasSize(2);
        assertThat(rig.truePose("pioneer").distanceMm(new Pose(7000, -6000, 0))).isLessThan(50);
        assertThat(rig.truePose("pioneer2").distanceMm(new Pose(-7000, -6000, 0)))
                .isLessThan(50);
        assertThat(contacts()).isZero();
    }

    @Test
    void oneThatStandsInTheOnlyDoorIsNamed() throws InterruptedException {
        addOther(new Pose(-3000, 4900, 90));

        assertThat(rig.run("1 goto -3000 3600"))
                .last()
                .asString()
                .contains("failed: robot 2 (Pioneer) stands in the way for 20 s");
        assertThat(contacts()).isZero();
    }

    @Test
    void theAnswerMarksThePlaceOfARobotThatEstimatesIt() throws InterruptedException {
        rig.add("aibo").place(rig.truePose("aibo"));

        assertThat(rig.run("2 goto -3600 2600"))
                .last()
                .asString()
                .matches(".*: done \\(about -?\\d+ mm, about -?\\d+ mm, about -?[\\d.]+ deg; [\\d.]+ s\\)");
    }

    @Test
    void aRobotThatEstimatesItsPlaceDrivesAStraightWayWithoutStops() throws InterruptedException {
        MajicBot dog = rig.add("aibo");
        dog.place(rig.truePose("aibo"));
        rig.run("2 move 100");
        double begunS = rig.lab().time().nanos() / 1e9;

        assertThat(rig.run("2 goto -2700 2500")).last().asString().contains(": done (about ");
        double tookS = rig.lab().time().nanos() / 1e9 - begunS;
        assertThat(tookS).isLessThan(1.3 * 1200 / dog.get("cruise").number());
    }

    @Test
    void anotherRobotThatDrivesAheadIsNotTakenForAWall() throws InterruptedException {
        addOther(new Pose(-7500, -6300, 0));
        rig.say("2 goto 7000 -6300");
        rig.run("1 goto 5500 -6300", "1 wait");

        assertThat(robot.uncertainty().isKnown()).isTrue();
        assertThat(robot.state().pose().distanceMm(rig.truePose("pioneer"))).isLessThan(60);
        assertThat(contacts()).isZero();
    }
}
