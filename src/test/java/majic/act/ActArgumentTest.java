package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the description of an argument and its form in an act's file. */
class ActArgumentTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "speed = 200mm/s from 50 to 400 \"how fast it drives\"",
                "wait = 0.5s \"\"",
                "lean = -3.25deg from -10 \"to the left\"",
                "gain = 0.000001 to 1 \"how strongly it steers\"",
                "rounds = 3 whole from 1 to 10 \"how often\"",
                "heat = 20°C \"of the room\"",
                "brake = 100mm/s² \"how hard it brakes\"",
                "loud = yes \"whether it barks\"",
                "light = off \"at the end\"",
                "side = right or left \"where the wall is\"",
                "song = \"bark at 9.wav\" \"what it plays\"",
                "song = \"\" \"what it plays; empty for none\""
            })
    void theFormInAFileIsReadBackAsTheSameArgument(String text) {
        ActArgument argument = ActArgument.parse(text);
        assertThat(argument).hasToString(text);
        assertThat(ActArgument.parse(argument.toString())).isEqualTo(argument);
    }

    @Test
    void aNumberHasItsUnitItsRangeAndItsDefault() {
        ActArgument speed = ActArgument.parse("speed = 200mm/s from 50 to 400 \"how fast it drives\"");
        assertThat(speed.parameter())
                .isEqualTo(Parameter.number("speed", Unit.MM_PER_S, "how fast it drives")
                        .within(50, 400));
        assertThat(speed.initial()).isEqualTo(Value.of(200, Unit.MM_PER_S));
        assertThat(speed.typed()).isEqualTo("200mm/s");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "speed | is not an argument, as in",
                "2speed = 3 \"\" | is not an argument, as in",
                "speed = 3 | is not an argument, as in",
                "speed = 3miles \"\" | there is no unit miles",
                "speed = 3 from 4 to 1 \"\" | a range runs from low to high",
                "speed = 500mm/s to 400 \"\" | speed 500 mm/s: outside",
                "rounds = 2.5 whole \"\" | not a whole number",
                "side = right \"\" | right alone is no choice",
                "speed = 1e9 \"\" | there is no unit e9"
            })
    void anyOtherTextIsRefused(String text, String why) {
        assertThatThrownBy(() -> ActArgument.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(why);
    }

    @Test
    void theExplanationIsOneVisibleLine() {
        Parameter odd = Parameter.number("speed", Unit.NONE, "how \"fast\"\n\u202Eit  is");
        assertThat(new ActArgument(odd, Value.of(1, Unit.NONE))).hasToString("speed = 1 \"how 'fast' it is\"");
    }

    @Test
    void aTextThatCannotBeTypedIsNoDefault() {
        assertThatThrownBy(() -> new ActArgument(Parameter.text("song", ""), Value.text("say \"wuff\"")))
                .hasMessageContaining("without quotation marks");
    }

    @Test
    void aWrongNameIsAnsweredWithTheRightOnes() {
        ActArgument speed = ActArgument.parse("speed = 1 \"\"");
        assertThat(ActArgument.unknown("sped", List.of(speed)))
                .isEqualTo("sped: the act has no such argument; did you mean speed?");
        assertThat(ActArgument.unknown("colour", List.of(speed)))
                .isEqualTo("colour: the act has no such argument; it takes speed");
        assertThat(ActArgument.unknown("colour", List.of()))
                .isEqualTo("colour: the act has no such argument; it takes none");
    }
}
