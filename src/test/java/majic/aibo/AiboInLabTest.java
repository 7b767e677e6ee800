package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.MajicBot;
import majic.bot.Unit;
import majic.bot.Value;
import majic.inlab.LabRig;
import majic.team.ManualControl;
import org.junit.jupiter.api.Test;

/** Tests the Aibo's driver with the simulated dog. */
class AiboInLabTest {
    @Test
    void theHeadTakesACommandedPositionRightAfterAWalk() throws InterruptedException {
        try (LabRig rig = LabRig.noisy(1)) {
            MajicBot dog = rig.add("aibo");
            dog.move(200);

            dog.set("headPan", 40);
            rig.lab().time().sleep(1);

            assertThat(dog.get("headPan").number()).isCloseTo(40, within(1.0));
        }
    }

    @Test
    void thePostureIsTakenAndReported() {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");

            dog.set("posture", "sit");

            assertThat(dog.get("posture")).hasToString("sit");
            assertThat(dog.get("motors").isYes()).isTrue();
        }
    }

    @Test
    void aSlowerCruiseReallyWalksSlowerAndJustAsFar() {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");
            dog.move(200);
            double usualMm = rig.truePose("aibo").xMm();
            dog.set("cruise", 50);

            double slowSeconds = dog.move(200).seconds();

            assertThat(slowSeconds).isGreaterThan(3.9);
            assertThat(rig.truePose("aibo").xMm() - usualMm).isCloseTo(200, within(15.0));
        }
    }

    @Test
    void calibratingTellsWhatToDoAndTeachesTheDogItsPace() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");
            double from = rig.truePose("aibo").xMm();

            assertThat(rig.run("1 calibrate forward"))
                    .anyMatch(line -> line.contains("mark where its fore paws stand"))
                    .anyMatch(line -> line.contains("type what you saw, as in: calibrate forward 1000mm"));
            long measured = Math.round(rig.truePose("aibo").xMm() - from);

            assertThatThrownBy(() -> calibrate(dog, "forward", Value.of(measured / 10.0, Unit.MM)))
                    .hasMessageContaining("would do");
            assertThat(rig.run("1 calibrate forward " + measured + "mm"))
                    .anyMatch(line -> line.contains("forward took 12.00 ms for a mm before"));
            assertThat(rig.run("1 get forwardFactor")).anyMatch(line -> line.contains("forwardFactor = "));
            assertThat(measured).isBetween(900L, 1100L);
        }
    }

    @Test
    void aTurnIsMeasuredInDegrees() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            MajicBot dog = rig.add("aibo");

            rig.run("1 calibrate right");

            assertThatThrownBy(() -> calibrate(dog, "right", Value.of(370, Unit.MM)))
                    .hasMessageContaining("above 0 in deg");
            assertThat(rig.run("1 calibrate right 370deg")).anyMatch(line -> line.contains("takes 27.0"));
        }
    }

    @Test
    void drivingTheDogByHandTakesItsJointsToo() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            rig.add("aibo");
            try (ManualControl hand = new ManualControl(rig.team().member(1))) {
                hand.drive(60, 0);

                assertThat(rig.run("1 set headPan 20", "1 set posture sit", "1 urbi \"headPan.val = 20\""))
                        .filteredOn(line -> line.equals("1 is driven by hand; \"1 stop\" ends it"))
                        .hasSize(3);
                assertThat(rig.run("1 get motors")).anyMatch(line -> line.startsWith("1 motors = "));
            }
        }
    }

    private static String calibrate(MajicBot dog, String direction, Value measured) {
        return dog.run("calibrate", List.of(Value.text(direction), measured));
    }
}
