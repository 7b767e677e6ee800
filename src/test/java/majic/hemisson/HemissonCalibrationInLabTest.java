package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;

/** Tests that a Hemisson is calibrated with a ruler, and that its motions use the result. */
class HemissonCalibrationInLabTest {
    @Test
    void aStretchThatWasMeasuredScalesAllSpeeds() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add("hemisson");

            assertThat(rig.run("1 calibrate forward"))
                    .anyMatch(line -> line.contains("mark where it stands"))
                    .anyMatch(line -> line.contains("measure it and type what you saw, as in: calibrate forward 4"));
            double covered = bot.state().pose().xMm();
            rig.run("1 calibrate forward " + Math.round(covered / 2) + "mm");

            assertThat(bot.get("speedTable").toString()).startsWith("1.5 mm/s, 9 mm/s, 21");
            Pose before = rig.truePose("hemisson");
            bot.move(100);
            assertThat(distance(before, rig.truePose("hemisson"))).isCloseTo(200, within(6.0));
        }
    }

    @Test
    void turnsThatWereCountedGiveTheDistanceOfTheWheels() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add("hemisson");
            rig.run("1 calibrate spin");

            assertThat(rig.run("1 calibrate spin 480deg")).anyMatch(line -> line.contains("are 99"));
            assertThat(rig.run("1 calibrate spin 7deg"))
                    .anyMatch(line -> line.contains("between 159 and 1590 deg would do"));

            assertThat(bot.get("wheelDistance").number()).isCloseTo(99.4, within(0.6));
        }
    }

    @Test
    void aFasterWheelIsEasedAndShownToBe() throws Exception {
        try (LabRig rig = LabRig.exact()) {
            MajicBot bot = rig.add("hemisson");
            bot.set("trim", 5);
            double before = rig.truePose("hemisson").headingDeg();

            bot.move(400);

            double turned = Pose.normalised(rig.truePose("hemisson").headingDeg() - before);
            double expected = -Math.toDegrees(0.05 * 400 / 90);
            assertThat(turned).isCloseTo(expected, within(2.5));
            assertThat(bot.get("heading").number()).isCloseTo(0, within(1.5));
        }
    }

    private static double distance(Pose from, Pose to) {
        return Math.hypot(to.xMm() - from.xMm(), to.yMm() - from.yMm());
    }
}
