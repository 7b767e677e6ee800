package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.MajicBot;
import majic.bot.Pose;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that the commanded distance matches the distance between the lab's own poses. */
class TravelInTheLabTest {
    @ParameterizedTest(name = "{0} moves {1} mm")
    @CsvSource({
        "pioneer, 1000, 0.02",
        "pioneer, -1000, 0.02",
        "pioneer, 200, 0.05",
        "pioneer, -200, 0.05",
        "aibo, 1000, 0.05",
        "aibo, -1000, 0.05",
        "aibo, 100, 0.1",
        "hemisson, 1000, 0.05",
        "hemisson, -1000, 0.05",
        "hemisson, 100, 0.05"
    })
    void aMoveCoversItsDistance(String type, double mm, double tolerance) {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add(type);
            Pose before = rig.truePose(type);

            bot.move(mm);

            assertThat(ahead(before, rig.truePose(type))).isCloseTo(mm, within(Math.abs(mm) * tolerance));
        }
    }

    @ParameterizedTest(name = "{0} turns {1} deg")
    @CsvSource({
        "pioneer, 90, 2",
        "pioneer, -90, 2",
        "pioneer, 540, 2",
        "aibo, 90, 4.5",
        "aibo, -90, 4.5",
        "hemisson, 90, 4.5",
        "hemisson, -90, 4.5",
        "hemisson, 360, 18"
    })
    void aTurnCoversItsAngle(String type, double degrees, double toleranceDeg) {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add(type);
            Pose before = rig.truePose(type);

            bot.turn(degrees);

            double turned = rig.truePose(type).headingDeg() - before.headingDeg();
            assertThat(Pose.normalised(turned - degrees)).isCloseTo(0, within(toleranceDeg));
        }
    }

    @ParameterizedTest(name = "{0} at {1} mm/s")
    @CsvSource({"pioneer, 400", "aibo, 80", "hemisson, 100"})
    void aDriveForATimeIsDoneWhenTheRobotIsStationary(String type, double mmPerSec) throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add(type);

            assertThat(rig.run("1 drive " + mmPerSec + " 0 for 1s")).anyMatch(line -> line.contains("done"));

            assertThat(bot.get("moving")).hasToString("no");
            Pose atTheEnd = rig.truePose(type);
            rig.lab().time().sleep(1);
            assertThat(ahead(atTheEnd, rig.truePose(type))).isCloseTo(0, within(1.0));
        }
    }

    private static double ahead(Pose before, Pose after) {
        double heading = Math.toRadians(before.headingDeg());
        return (after.xMm() - before.xMm()) * Math.cos(heading) + (after.yMm() - before.yMm()) * Math.sin(heading);
    }
}
