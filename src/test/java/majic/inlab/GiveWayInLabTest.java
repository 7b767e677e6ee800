package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.Navigator;
import majic.team.ManualControl;
import majic.team.Member;
import majicsim.LabOptions;
import majicsim.world.Room;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A Pioneer that is sent through the only door of a room, in which another one stands. */
class GiveWayInLabTest {
    private static final Path OFFICE = Path.of("sims", "worlds", "office.map");
    private static final Pose DOOR = new Pose(-3000, 4900, 90);
    private static final Pose ROOM = new Pose(-3000, 3200, 0);

    @AutoClose
    private final LabRig rig = LabRig.of(office());

    private final MajicBot standing;

    GiveWayInLabTest() throws InterruptedException {
        rig.run("map open " + OFFICE);
        add("pioneer", new Pose(-5500, 6000, 0));
        standing = add("pioneer2", DOOR);
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

    private MajicBot add(String type, Pose place) throws InterruptedException {
        rig.lab().place(type, place);
        rig.lab().time().sleep(0.5);
        MajicBot robot = rig.add(type);
        robot.place(rig.truePose(type));
        return robot;
    }

    private Navigator navigator() {
        return rig.session().map().navigator();
    }

    private int contacts() {
        return rig.lab().bumps().values().stream().mapToInt(Integer::intValue).sum();
    }

    private double fromDoorMm() {
        return rig.truePose("pioneer2").distanceMm(DOOR);
    }

    @Test
    void oneThatGivesWayDrivesAsideAndTheOtherOneArrives() throws InterruptedException {
        List<String> answers = rig.run("2 set giveWay on", "1 goto -3000 3200", "1,2 wait");

        assertThat(answers)
                .contains("2: makes room for robot 1 (Pioneer)")
                .anySatisfy(line -> assertThat(line)
                        .matches("2 goto -?\\d+ -?\\d+ \\(makes room for 1\\): done \\(.* deg; [\\d.]+ s\\)"))
                .anySatisfy(line -> assertThat(line).contains("1 goto -3000 3200: done ("));
        assertThat(rig.truePose("pioneer").distanceMm(ROOM)).isLessThan(50);
        assertThat(fromDoorMm()).isGreaterThan(500);
        assertThat(contacts()).isZero();
    }

    @Test
    void oneThatDoesNotGiveWayIsWaitedForAndNeverMoved() throws InterruptedException {
        assertThat(rig.run("1 goto -3000 3200"))
                .last()
                .asString()
                .endsWith("failed: robot 2 (Pioneer) stands in the way for 20 s");
        assertThat(fromDoorMm()).isZero();
    }

    @Test
    void oneThatRunsAnActIsNotAsked() throws InterruptedException {
        rig.run("2 set giveWay on", "map place here -3000 4900");
        rig.say("2 act Patrol places=here times=2 pause=60s");
        Member member = rig.team().members().get(1);
        assertThat(rig.await(() -> member.owner() != null)).isTrue();

        rig.say("1 goto -3000 3200");
        assertThat(rig.await(() -> rig.team().members().get(0).isIdle())).isTrue();

        assertThat(rig.said())
                .anySatisfy(line -> assertThat(line).endsWith("failed: robot 2 (Pioneer) stands in the way for 20 s"))
                .noneSatisfy(line -> assertThat(line).contains("makes room"));
        assertThat(fromDoorMm()).isLessThan(20);
    }

    @Test
    void oneThatIsDrivenByHandIsNotAsked() throws InterruptedException {
        rig.run("2 set giveWay on");
        ManualControl control = new ManualControl(rig.team().members().get(1));
        assertThat(rig.run("1 goto -3000 3200")).last().asString().endsWith("stands in the way for 20 s");
        control.close();
        assertThat(fromDoorMm()).isZero();
    }

    @Test
    void oneThatWasStoppedWhileItMakesRoomIsNotAskedAgain() throws InterruptedException {
        rig.run("2 set giveWay on");
        rig.say("1 goto -3000 3200");
        assertThat(rig.await(() -> navigator().way(standing).isPresent())).isTrue();

        assertThat(rig.run("2 stop"))
                .anySatisfy(line -> assertThat(line).contains("(makes room for 1): stopped"))
                .anySatisfy(line -> assertThat(line)
                        .endsWith(
                                "robot 2 (Pioneer) stands in the way for 20 s; it was asked to make room and did not"));
        assertThat(fromDoorMm()).isLessThan(200);
    }

    @Test
    void aStopOfAllEndsBothAndNothingResumes() throws InterruptedException {
        rig.run("2 set giveWay on");
        rig.say("1 goto -3000 3200");
        assertThat(rig.await(() -> standing.state().moving())).isTrue();

        rig.run("stop", "release");
        rig.lab().time().sleep(2);
        List<Pose> stood = List.of(rig.truePose("pioneer"), rig.truePose("pioneer2"));
        rig.lab().time().sleep(15);
        assertThat(List.of(rig.truePose("pioneer"), rig.truePose("pioneer2"))).isEqualTo(stood);
        assertThat(navigator().way(standing)).isEmpty();
        assertThat(rig.team().members()).allMatch(Member::isIdle);
    }
}
