package majic.act.make;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import majic.act.ActArgument;
import majic.act.ActException;
import majic.act.MajicAct;
import majic.act.Sources;
import majic.act.file.ActFile;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that the fields of an act are its arguments, in its file and in the act that is made of it. */
class ActArgumentsTest {
    private static final String SOURCE = """
            import majic.act.Argument;
            import majic.act.MajicAct;
            import majic.bot.Unit;

            public class Stroll extends Walk {
                @Argument(value = "how often it walks", from = 1, to = 9)
                private int rounds = 2;

                @Argument("whether it barks")
                private boolean loud;

                @Argument(value = "the side of the wall", choices = {"left", "right"})
                private String side = "right";

                @Argument("what it says")
                private String words = "good day";

                protected void behave() {}

                public String toString() { return speed + " " + rounds + " " + loud + " " + side + " " + words; }
            }

            abstract class Walk extends MajicAct {
                @Argument(value = "how fast it walks", unit = Unit.MM_PER_S, from = 50, to = 400)
                protected double speed = 200;
            }
            """;

    @TempDir
    static Path folder;

    private static ActFile stroll;

    @BeforeAll
    static void make() {
        stroll = ActFile.of("Stroll.act", Sources.act(folder, "Stroll", SOURCE));
    }

    private static MajicAct loaded() {
        return stroll.load(Sources.trusting(stroll));
    }

    @Test
    void theFileListsThemWithoutLoadingTheAct() {
        assertThat(stroll.arguments())
                .extracting(ActArgument::toString)
                .containsExactly(
                        "speed = 200mm/s from 50 to 400 \"how fast it walks\"",
                        "rounds = 2 whole from 1 to 9 \"how often it walks\"",
                        "loud = no \"whether it barks\"",
                        "side = right or left \"the side of the wall\"",
                        "words = \"good day\" \"what it says\"");
        assertThat(stroll.describe()).anyMatch(line -> line.startsWith("arguments: speed = 200mm/s from 50 to 400"));
    }

    @Test
    void theActHasTheDefaultsUnlessOtherValuesAreGiven() {
        MajicAct act = loaded();
        assertThat(act).hasToString("200.0 2 false right good day");
        act.setArgument("SPEED", Value.of(300, Unit.NONE));
        act.setArgument("rounds", Value.of(9, Unit.NONE));
        act.setArgument("loud", Value.text("yes"));
        act.setArgument("side", Value.text("LEFT"));
        act.setArgument("words", Value.text("hello"));
        assertThat(act).hasToString("300.0 9 true left hello");
        assertThat(loaded()).hasToString("200.0 2 false right good day");
    }

    @Test
    void aWrongValueOrNameIsRefusedAndChangesNothing() {
        MajicAct act = loaded();
        assertThatThrownBy(() -> act.setArgument("speed", Value.of(500, Unit.MM_PER_S)))
                .isInstanceOf(ParameterException.class)
                .hasMessage("speed 500 mm/s: outside 50 … 400 mm/s");
        assertThatThrownBy(() -> act.setArgument("speed", Value.of(100, Unit.DEG)))
                .isInstanceOf(ParameterException.class)
                .hasMessage("speed 100 deg: not in mm/s");
        assertThatThrownBy(() -> act.setArgument("colour", Value.of(1, Unit.NONE)))
                .isInstanceOf(ActException.class)
                .hasMessageContaining("it takes speed, rounds, loud, side, words");
        assertThat(act).hasToString("200.0 2 false right good day");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "final double speed = 200 | the field 'speed' is static, final or transient, so it cannot be set",
                "static double speed = 200 | the field 'speed' is static, final or transient, so it cannot be set",
                "transient double speed = 200 | the field 'speed' is static, final or transient, so it cannot be set",
                "float speed = 200 | the field 'speed' cannot be an argument: it is a double, an int, a boolean or",
                "String speed | the field 'speed' cannot be an argument: it is a double, an int, a boolean or",
                "double speed = 9 | the field 'speed' cannot be an argument: speed 9 mm: outside 10",
                "double spe$ed = 20 | the field 'spe$ed' cannot be an argument: the name of an argument is a letter"
            })
    void aFieldThatCannotBeOneIsNamed(String field, String why) {
        String source = """
                public class Odd extends majic.act.MajicAct {
                    @majic.act.Argument(value = "", unit = majic.bot.Unit.MM, from = 10)
                    %s;
                    protected void behave() {}
                }
                """.formatted(field);
        assertThatThrownBy(() -> Sources.act(folder, "Odd", source))
                .isInstanceOf(ActException.class)
                .hasMessageContaining("Odd has a wrong argument: " + why);
    }
}
