package majic.script.conditions;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.drivertest.TestClock;
import majic.script.syntax.ConditionParser;
import majic.team.Member;
import majic.team.Team;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the text of a condition, by which another program evaluates it where robot 2 has another number. */
class UntilTextTest {
    private final TestClock clock = new TestClock();
    private final Team team = new Team(clock.time());
    private Member moving;

    @BeforeEach
    void addTwo() {
        team.add(FakeBot.on(clock.time()), OptionalInt.empty());
        moving = team.add(FakeBot.on(clock.time()), OptionalInt.empty());
    }

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "distanceFront < 30cm | distanceFront < 30cm",
                "2 distanceFront < 300 | distanceFront < 300",
                "not (2 bumped == yes or voltage < 11V) and distanceFront < headPan"
                        + " | not (bumped == yes or voltage < 11V) and distanceFront < headPan",
                "title == \"a b\" | title == \"a b\"",
            })
    void namesNoRobotWhenOnlyTheMovingOneIsRead(String until, String text) {
        assertThat(text(until)).contains(text);
    }

    @ParameterizedTest
    @CsvSource({"1 bumped == yes", "distanceFront < 300 or 1 bumped == yes", "any distanceFront < 300"})
    void isMissingWhenAnotherRobotIsReadAsWell(String until) {
        assertThat(text(until)).isEmpty();
    }

    @Test
    void readsTheSameConditionAgain() {
        String text = text("(bumped == yes or light == on) and not distanceFront > 300")
                .orElseThrow();

        assertThat(text(text)).contains(text);
    }

    private Optional<String> text(String until) {
        return new UntilGuard(ConditionParser.parse(until), new Selection(team), moving).text();
    }
}
