package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the shipped behaviours of the Aibo. */
@Tag("long")
class AiboActsInLabTest {
    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs();
    }

    @Test
    void theSquareClosesToAHairWhereNothingIsOff() throws InterruptedException {
        assertThat(gapOfTheSquare(LabRig::exact)).isLessThan(10);
    }

    /** Walks two metres with steps up to a tenth too long or too short and a drift of 3 to 5 degrees a metre. */
    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theSquareClosesWithinAnAibosLength(Supplier<LabRig> lab) throws InterruptedException {
        assertThat(gapOfTheSquare(lab)).isLessThan(250);
    }

    private static double gapOfTheSquare(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = ActLabs.with(lab, "aibo")) {
            Pose start = rig.truePose("aibo");
            assertThat(rig.run("1 act AiboSquare"))
                    .contains("1: AiboSquare: side 4")
                    .last()
                    .asString()
                    .startsWith("1 act AiboSquare: done");
            return start.distanceMm(rig.truePose("aibo"));
        }
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theHeadFindsWhatIsNearestAndStaysOnIt(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = lab.get()) {
            ActLabs.place(rig, "aibo", new Pose(0, 1500, 0));
            ActLabs.place(rig, "pioneer", new Pose(700, 2200, 45));
            MajicBot dog = rig.add("aibo");
            assertThat(rig.run("1 act HeadScan"))
                    .anyMatch(line -> line.startsWith("1: HeadScan: the nearest thing is"));

            assertThat(dog.get("headPan").number()).isBetween(30.0, 60.0);
            assertThat(rig.truePose("aibo")).isEqualTo(new Pose(0, 1500, 0));
        }
    }

    @ParameterizedTest(name = "in {0}")
    @MethodSource("labs")
    void theDanceEndsInThePoseInWhichItBegan(Supplier<LabRig> lab) throws InterruptedException {
        try (LabRig rig = ActLabs.with(lab, "aibo")) {
            Pose before = rig.truePose("aibo");
            assertThat(rig.run("1 act Dance")).last().asString().startsWith("1 act Dance: done");

            assertThat(rig.truePose("aibo").distanceMm(before)).isLessThan(20);
            assertThat(rig.truePose("aibo").headingDeg()).isBetween(-20.0, 20.0);
            assertThat(rig.run("1 get posture,headPan,tailPan"))
                    .containsExactly("1 posture = stand", "1 headPan = 0 deg", "1 tailPan = 0 deg");
        }
    }
}
