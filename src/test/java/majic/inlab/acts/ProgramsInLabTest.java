package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.nav.CurrentMap;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.Test;

/** Runs the examples in MAJIC Script, and what the Java examples do with a connected robot, in the stepped lab. */
class ProgramsInLabTest {
    private static final Pose NEAR_THE_WALL = new Pose(3000, 0, 0);

    @Test
    void threeUnlikeRobotsRaceByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            assertThat(run(rig, "race.majic"))
                    .filteredOn(line -> line.contains("move 50cm until distanceFront < near: done"))
                    .hasSize(3);
        }
    }

    @Test
    void thePioneerWandersByScriptAndByItsAct() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "pioneer", NEAR_THE_WALL);
            assertThat(run(rig, "wander.majic")).noneMatch(line -> line.contains("failed"));
            assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
        }
        try (LabRig rig = LabRig.exact()) {
            rig.add("pioneer");
            rig.say("1 act PioneerWander");
            assertThat(rig.await(() -> rig.team().member(1).bot().state().moving()))
                    .isTrue();
        }
    }

    @Test
    void theHemissonFollowsTheLineByScript() throws Exception {
        try (LabRig rig = lineLab()) {
            assertThat(run(rig, "line.majic")).noneMatch(line -> line.contains("failed"));
            LineInLab.assertIsAtTheObstacle(rig);
        }
    }

    @Test
    void theHemissonFollowsTheLineByJava() throws Exception {
        try (LabRig rig = lineLab()) {
            call("LineFollower", "follow", rig.add("hemisson"));
            LineInLab.assertIsAtTheObstacle(rig);
        }
    }

    private static LabRig lineLab() {
        LabRig rig = LabRig.exact();
        ActLabs.place(rig, "hemisson", LineInLab.BESIDE_IT);
        ActLabs.place(rig, "pioneer", LineInLab.OBSTACLE);
        return rig;
    }

    @Test
    void theDogTurnsAtTheWallByJava() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "aibo", NEAR_THE_WALL);
            call("WanderDog", "wander", rig.add("aibo"));
            assertThat(rig.truePose("aibo").distanceMm(NEAR_THE_WALL)).isGreaterThan(100);
            assertThat(Math.abs(rig.truePose("aibo").headingDeg())).isBetween(80.0, 120.0);
            assertThat(ActLabs.bumps(rig)).containsEntry("aibo", 0);
        }
    }

    @Test
    void theDogWandersByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "aibo", NEAR_THE_WALL);
            assertThat(run(rig, "wander_dog.majic")).noneMatch(line -> line.contains("failed"));
            assertThat(rig.truePose("aibo").distanceMm(NEAR_THE_WALL)).isGreaterThan(100);
            assertThat(ActLabs.bumps(rig)).containsEntry("aibo", 0);
        }
    }

    @Test
    void threeUnlikeRobotsGoToAndFroByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            assertThat(run(rig, "to_and_fro.majic"))
                    .noneMatch(line -> line.contains("failed"))
                    .filteredOn(line -> line.contains("turn 180: done"))
                    .hasSize(18);
            assertThat(ActLabs.bumps(rig).values()).containsOnly(0);
        }
    }

    @Test
    void thePioneerFollowsTheWallByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            ActLabs.place(rig, "pioneer", NEAR_THE_WALL);
            assertThat(run(rig, "wall.majic")).noneMatch(line -> line.contains("failed"));
            assertThat(rig.team().member(1).bot().get("distanceRight").number()).isBetween(300.0, 800.0);
            assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
        }
    }

    @Test
    void thePioneerSearchesInASpiralByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            assertThat(run(rig, "spiral.majic"))
                    .noneMatch(line -> line.contains("failed"))
                    .anyMatch(line -> line.matches("the search ended at -?[0-9.]+ mm -?[0-9.]+ mm"));
            assertThat(ActLabs.bumps(rig)).containsEntry("pioneer", 0);
        }
    }

    @Test
    void theDogWalksHalfAMetreByScript() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            Pose start = rig.truePose("aibo");
            run(rig, "walk.majic");
            assertThat(rig.truePose("aibo").distanceMm(start)).isBetween(480.0, 520.0);
        }
    }

    @Test
    void aTurtleBotAndADogWanderByTheSameLines() throws Exception {
        try (LabRig rig = LabRig.exactWithRos("2")) {
            Pose start = rig.truePose("ros");
            assertThat(run(rig, "ros.majic"))
                    .noneMatch(line -> line.contains("failed"))
                    .filteredOn(line -> line.contains("turn 100: done"))
                    .hasSize(10);
            assertThat(rig.truePose("ros").distanceMm(start)).isGreaterThan(100);
            assertThat(ActLabs.bumps(rig)).containsEntry("ros", 0).containsEntry("aibo", 0);
        }
    }

    @Test
    void threePioneersPatrolAnOfficeByScript() throws Exception {
        LabOptions office = LabOptions.exactOnFreePorts()
                .withPioneer("p3dx-sh+laser")
                .withPioneers(3)
                .withRoom(Room.load(Path.of("sims", "worlds", "office.map")));
        try (LabRig rig = LabRig.of(office)) {
            ActLabs.place(rig, "pioneer3", new Pose(0, -6000, 90));
            List.of("pioneer", "pioneer2", "pioneer3")
                    .forEach(name -> rig.add(name).place(rig.truePose(name)));

            assertThat(run(rig, "patrol.majic"))
                    .filteredOn(line -> line.contains("act Patrol"))
                    .hasSize(3)
                    .allMatch(line -> line.contains(": done ("));
            assertThat(ActLabs.bumps(rig).values()).containsOnly(0);
        }
    }

    @Test
    void aTurtleBotWandersByJava() throws Exception {
        try (LabRig rig = LabRig.exactWithRos("1")) {
            Pose start = rig.truePose("ros");
            call("RosWander", "wander", rig.add("ros"));
            assertThat(rig.truePose("ros").distanceMm(start)).isGreaterThan(100);
            assertThat(ActLabs.bumps(rig)).containsEntry("ros", 0);
        }
    }

    @Test
    void aRoverDrivesAroundACornerByJava() throws Exception {
        try (LabRig rig = LabRig.exactWithMavlink("rover+ready")) {
            Pose start = new Pose(1200, 0, 0);
            ActLabs.place(rig, "mavlink", start);
            assertThat(printed("RoverDrive", "drive", rig.add("mavlink")))
                    .hasSize(2)
                    .doesNotHaveDuplicates()
                    .allMatch(line -> line.matches("-35\\.363\\d* ° 149\\.165\\d* °"));
            assertThat(rig.truePose("mavlink").distanceMm(start.plus(new Pose(1500, 500, 90))))
                    .isLessThan(250);
            assertThat(ActLabs.bumps(rig)).containsEntry("mavlink", 0);
        }
    }

    @Test
    void aCopterFliesAlongASquareAndLandsByAScriptThatIsAnAct() throws Exception {
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready")) {
            ActLabs.place(rig, "mavlink", new Pose(1200, 0, 0));
            rig.add("mavlink");
            rig.lab().time().sleep(2);
            Pose start = rig.truePose("mavlink");

            assertThat(rig.run("1 set fence 5000 500 4000", "1 act examples/flight.majic side=1m"))
                    .anyMatch(line -> line.matches("landed at -?[\\d.]+ mm -?[\\d.]+ mm"))
                    .last()
                    .asString()
                    .contains("act examples/flight.majic side=1m: done (");

            assertThat(rig.truePose("mavlink").distanceMm(start)).isLessThan(400);
            rig.lab().simulators().besideMavlink("mavlink", copter -> {
                assertThat(copter.heightM()).isZero();
                assertThat(copter.isArmed()).isFalse();
                assertThat(copter.crashes()).isZero();
                assertThat(copter.disarmsInFlight()).isZero();
            });
        }
    }

    @Test
    void theScansOfATurtleBotArePrintedByJava() throws Exception {
        try (LabRig rig = LabRig.exactWithRos("2")) {
            assertThat(printed("PrintScans", "print", rig.add("ros")))
                    .hasSizeGreaterThan(2)
                    .allMatch(line -> line.matches("laser at Pose\\[.*]: the nearest echo is at [0-9.]+ mm"));
        }
    }

    private static List<String> printed(String example, String method, MajicBot robot) throws Exception {
        PrintStream console = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            call(example, method, robot);
        } finally {
            System.setOut(console);
        }
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void aMapIsBuiltWithATurtleBotByJava() throws Exception {
        try (LabRig rig = LabRig.exactWithRos("2")) {
            CurrentMap map = (CurrentMap) call("BuildMap", "build", rig.add("ros"));

            assertThat(map.mappedBy()).isEmpty();
            assertThat(map.text()).matches("[0-9.]+ by [0-9.]+ m, cells of 50 mm, 0 places");
        }
    }

    @Test
    void aPioneerGoesThereAndBackByJava() throws Exception {
        try (LabRig rig = LabRig.exactWithPioneer("p3dx-sh")) {
            Pose start = rig.truePose("pioneer");
            call("GoThere", "drive", rig.add("pioneer"));

            assertThat(rig.truePose("pioneer").distanceMm(start)).isLessThan(60);
        }
    }

    /** Runs a script with the robots of the lab in place of those that it names. */
    private static List<String> run(LabRig rig, String script) throws Exception {
        return rig.run(Files.readString(Path.of("examples", script))
                .replaceAll("add (\\w+):\\S+", "add sim:$1")
                .lines()
                .toArray(String[]::new));
    }

    /**
     * Calls a method of an example and returns what it returns; the examples are in no package, so no test can name
     * them.
     */
    private static Object call(String example, String method, MajicBot robot) throws Exception {
        Method called = Class.forName(example).getDeclaredMethod(method, MajicBot.class);
        called.setAccessible(true);
        return called.invoke(null, robot);
    }
}
