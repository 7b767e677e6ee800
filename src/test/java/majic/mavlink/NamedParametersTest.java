package majic.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The parameters of an autopilot by their names. */
class NamedParametersTest {
    @AutoClose
    private final DrivenRover robot = new DrivenRover().ready();

    private final MajicMavlink bot = robot.bot();

    private static Value number(double value) {
        return Value.of(value, Unit.NONE);
    }

    @Test
    void aParameterIsReadWhenItIsAskedForAndListedFromThenOn() {
        assertThat(bot.parameters()).extracting(Parameter::name).noneMatch(name -> name.startsWith("param/"));

        assertThat(bot.get("param/WP_SPEED")).isEqualTo(number(2));
        robot.rover.parameters.put("WP_SPEED", 3f);
        assertThat(bot.get("param/wp_speed")).isEqualTo(number(3));

        assertThat(bot.parameters()).extracting(Parameter::name).contains("param/WP_SPEED");
    }

    @Test
    void aNameThatIsNotAnsweredIsUnknownWithTheReason() {
        assertThat(bot.get("param/NO_SUCH").toString())
                .isEqualTo("unknown (the autopilot has no parameter NO_SUCH, or did not answer within 4.5 s)");
        assertThat(robot.rover.received.stream()
                        .filter(got -> got.id() == 20 && got.text(4, 16).equals("NO_SUCH")))
                .hasSize(3);
    }

    @Test
    void aParameterThatIsSetIsReadAfterwards() {
        bot.set("param/FS_GCS_ENABLE", 1);

        assertThat(robot.rover.parameters.get("FS_GCS_ENABLE")).isEqualTo(1f);
        assertThat(bot.get("failsafe").toString()).contains("HOLD");
    }

    @Test
    void anOldValueThatComesAfterTheRequestIsNotTakenForTheAnswer() {
        robot.rover.sendsOldValues = true;

        bot.set("param/WP_SPEED", 3);

        assertThat(robot.rover.parameters.get("WP_SPEED")).isEqualTo(3f);
        assertThat(bot.get("param/WP_SPEED")).isEqualTo(number(3));
    }

    @Test
    void whatTheAutopilotKeepsIsReadAnew() {
        robot.rover.keepsParameters = true;
        robot.rover.received.clear();

        assertThatThrownBy(() -> bot.set("param/WP_SPEED", 3))
                .isInstanceOf(BotException.class)
                .hasMessage("WP_SPEED: the autopilot keeps 2.0 in place of 3.0");
        assertThat(robot.rover.received.stream().filter(got -> got.id() == 20)).hasSize(2);
        assertThat(robot.rover.received.stream().filter(got -> got.id() == 23)).hasSize(1);
    }

    @Test
    void aParameterThatThereIsNotCannotBeSet() {
        assertThatThrownBy(() -> bot.set("param/NO_SUCH", 1))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("the autopilot has no parameter of this name");
    }

    @Test
    void aWholeParameterTakesNoFraction() {
        assertThatThrownBy(() -> bot.set("param/FS_ACTION", 1.5)).hasMessageContaining("not a whole number");
    }

    @Test
    void allNamesAreAskedForOnceWhenTheyAreCompletedAndLostOnesAgain() {
        robot.rover.lostIndex = 1;
        assertThat(requestsOfAll()).isZero();

        assertThat(bot.unlistedParameters("speed")).isEmpty();
        assertThat(requestsOfAll()).isZero();
        bot.unlistedParameters("param/");
        robot.pass(3);
        bot.unlistedParameters("PARAM/fs");

        assertThat(bot.unlistedParameters("PARAM/fs"))
                .extracting(Parameter::name)
                .containsExactly("param/FS_ACTION", "param/FS_GCS_ENABLE");
        assertThat(bot.unlistedParameters("param/"))
                .hasSize(robot.rover.parameters.size())
                .allMatch(parameter -> parameter.readable() && parameter.writable());
        assertThat(requestsOfAll()).isEqualTo(1);
        assertThat(bot.parameters()).extracting(Parameter::name).noneMatch(name -> name.startsWith("param/"));
    }

    private long requestsOfAll() {
        return robot.rover.received.stream().filter(got -> got.id() == 21).count();
    }

    @Test
    void aNameThatNoAutopilotCanHaveIsRefusedAtOnce() {
        assertThatThrownBy(() -> bot.get("param/A_NAME_OF_MORE_THAN_16"))
                .isInstanceOf(ParameterException.class)
                .hasMessageContaining("up to 16 letters");
    }

    @Test
    void aWholeNumberThatAFloatCannotHoldIsNotSaidToBeSet() {
        assertThatThrownBy(() -> bot.set("param/FS_ACTION", 16_777_217))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("the autopilot keeps 1.6777216E7");
    }

    @Test
    void thoseOfAnUnknownAutopilotAreBitsAndItsFailsafeIsUnknown() {
        try (DrivenRover unknown = new DrivenRover()) {
            unknown.rover.autopilot = 0;
            unknown.rover.parameters.put("FS_GCS_ENABLE", Float.intBitsToFloat(1));
            unknown.ready();

            assertThat(unknown.bot().get("param/FS_GCS_ENABLE")).isEqualTo(number(1));
            assertThat(unknown.bot().get("failsafe").toString()).contains("does not know the failsafes");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {7, -1, 16_777_217, -5_000_000, 2_139_095_041})
    void wholeNumbersOfPx4AreExact(int number) {
        try (DrivenRover px4 = new DrivenRover()) {
            px4.rover.autopilot = 12;
            px4.rover.parameters.put("SYS_NUMBER", 0f);
            px4.ready();

            px4.bot().set("param/SYS_NUMBER", number);

            assertThat(px4.bot().get("param/SYS_NUMBER")).isEqualTo(number(number));
        }
    }
}
