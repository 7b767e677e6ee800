package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the shipped behaviours of the Hemisson with the tape and the lamps of the standard room. */
@Tag("long")
class HemissonActsInLabTest {
    private static final Pose TAPE_MIDDLE = new Pose(-2000, -2900, 0);
    private static final double TAPE_STRAIGHT_X_MM = 700;
    private static final double TAPE_STRAIGHT_Y_MM = 100;
    private static final double TAPE_CORNER_MM = 200;
    private static final double SENSORS_AHEAD_MM = 57;
    private static final Pose LAMP = new Pose(500, -2600, 0);
    private static final int FIVE_MINUTES_IN_TENTHS = 3000;

    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs();
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theLineFollowerStaysOnTheTapeForTwoRounds(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "hemisson", new Pose(-2000, -2300, -90));
            rig.add("hemisson");
            rig.say("1 act LineFollow");
            ActLabs.awaitSaid(rig, "1: LineFollow: on the tape");

            double worst = 0;
            Rounds rounds = new Rounds(TAPE_MIDDLE);
            for (int tenth = 0; tenth < FIVE_MINUTES_IN_TENTHS && rounds.done() < 2; tenth++) {
                rig.lab().time().sleep(0.1);
                Pose now = rig.truePose("hemisson");
                rounds.add(now);
                worst = Math.max(worst, offTheTape(now));
            }
            assertThat(rounds.done())
                    .as("rounds, with %.0f mm off the tape at most; messages: %s", worst, rig.said())
                    .isGreaterThanOrEqualTo(2);
            assertThat(worst).as("mm off the tape; messages: %s", rig.said()).isLessThan(25);
        }
    }

    /** Returns the distance of the ground sensors from the middle of the tape, a rectangle with round corners. */
    private static double offTheTape(Pose robot) {
        double heading = Math.toRadians(robot.headingDeg());
        double x =
                Math.abs(robot.xMm() + SENSORS_AHEAD_MM * Math.cos(heading) - TAPE_MIDDLE.xMm()) - TAPE_STRAIGHT_X_MM;
        double y =
                Math.abs(robot.yMm() + SENSORS_AHEAD_MM * Math.sin(heading) - TAPE_MIDDLE.yMm()) - TAPE_STRAIGHT_Y_MM;
        double beyond = Math.hypot(Math.max(x, 0), Math.max(y, 0)) + Math.min(Math.max(x, y), 0);
        return Math.abs(beyond - TAPE_CORNER_MM);
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theLightSeekerEndsAtTheLamp(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "hemisson", new Pose(-500, -2100, 90));
            rig.add("hemisson");
            assertThat(rig.run("1 act LightSeek")).contains("1: LightSeek: here is the light");

            assertThat(rig.truePose("hemisson").distanceMm(LAMP)).isLessThan(500);
            assertThat(ActLabs.bumps(rig)).containsEntry("hemisson", 0);
        }
    }
}
