package majic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.bot.Pose;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The shipped behaviours of the Aibo do what they are for. */
@Timeout(120)
class AiboActsInLabTest {
    static Stream<Named<Supplier<LabRig>>> labs() {
        return ActLabs.labs();
    }

    @Test
    void theSquareClosesToAHairWhereNothingIsOff() throws InterruptedException {
        assertThat(gapOfTheSquare(LabRig::exact)).isLessThan(10);
    }

    /** Two metres by a dog's steps, each up to a tenth too long or too short, and drifting 3 to 5 degrees a metre. */
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
}
