package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Value;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a robot's readings are there as soon as it is connected. */
class FirstReadingsInLabTest {
    @ParameterizedTest
    @CsvSource({
        "aibo, distanceFront battery bumped ears",
        "pioneer, distanceFront distanceBack sonar voltage motors",
        "hemisson, distanceFront prox light switches"
    })
    void theReadingsAreKnownWhenConnectReturns(String type, String parameters) {
        try (LabRig rig = LabRig.exact()) {
            MajicBot robot = rig.add(type);

            assertThat(robot.state()).isNotSameAs(BotState.UNKNOWN);
            for (String parameter : (parameters + " x y heading speed moving").split(" ")) {
                assertThat(robot.get(parameter)).as(parameter).isNotInstanceOf(Value.Unknown.class);
            }
        }
    }
}
