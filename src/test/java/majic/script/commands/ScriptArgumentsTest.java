package majic.script.commands;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.run.Statement;
import majic.script.syntax.Mistake;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the arguments of a script: the lines that describe them, and their names in place of values. */
class ScriptArgumentsTest {
    private static final String ARGUMENTS = """
            # Arguments may stand behind comments and empty lines.

            argument speed = 0.2m/s from 50 to 0.4m/s "how fast"
            argument times = 3
            argument side = left or right
            argument song = "a b.wav" "what it plays"
            ARGUMENT light = on
            """;

    private final List<Mistake> mistakes = new ArrayList<>();

    private List<Statement> parse(String text, Map<String, Value> given) {
        return ScriptParser.parse(text, List.of(), given, mistakes);
    }

    private String line(String line, Map<String, Value> given) {
        List<Statement> script = parse(ARGUMENTS + line, given);
        assertThat(mistakes).isEmpty();
        return ((Statement.ForRobots) script.get(script.size() - 1)).command().text();
    }

    @Test
    void eachLineDescribesOne() {
        List<Statement> script = parse(ARGUMENTS, Map.of());
        assertThat(mistakes).isEmpty();
        assertThat(script).hasSize(5).allMatch(Statement.Argument.class::isInstance);
        Statement.Argument speed = (Statement.Argument) script.get(0);
        assertThat(speed.parameter().help()).isEqualTo("how fast");
        assertThat(speed.parameter().range().min()).isEqualTo(50);
        assertThat(speed.parameter().range().max()).isEqualTo(400);
        assertThat(speed.initial()).isEqualTo(Value.of(200, Unit.MM_PER_S));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "me drive $speed 0 | drive 200mm/s 0",
                "me drive -$SPEED 0 for $times | drive -200mm/s 0 for 3s",
                "me.drive($speed, $times) | drive 200mm/s 3",
                "me move 5 until x<$times and side == $side | move 5 until x < 3 and side == left",
                "me set side $side $times | set side left 3",
                "me play $song | play \"a b.wav\"",
                "me set light $light | set light on",
                "me play a$song | play a$song",
                "1 act Wander speed=$speed | act Wander speed=200mm/s"
            })
    void itsNameStandsForItsValue(String text, String words) {
        assertThat(line(text, Map.of())).isEqualTo(words);
    }

    @Test
    void aGivenValueReplacesTheDefault() {
        assertThat(line("me drive $speed -$times", Map.of("speed", Value.of(300, Unit.MM_PER_S))))
                .isEqualTo("drive 300mm/s -3");
        assertThat(line("me turn -$times", Map.of("times", Value.of(-1.5, Unit.NONE))))
                .isEqualTo("turn 1.5");
        List<Statement> script = parse(ARGUMENTS + "repeat $times\nend", Map.of("times", Value.of(7, Unit.NONE)));
        assertThat(((Statement.Repeat) script.get(5)).times().sample()).hasValue(7);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "me move $speed | 8:9: $speed is 200mm/s: a distance is expected here (mm, cm, m)",
                "me move $side | 8:9: $side is left: a distance (mm, cm, m) is expected here",
                "me move -$side | 8:9: -$side: left is not a number",
                "me move $sped | 8:9: $sped: there is no value of that name; did you mean speed? (there are light, side, song, speed, times)",
                "me set light $sped | 8:14: $sped: there is no value of that name; did you mean speed?",
                "$times move 5 | 8:1: $times: a name with $ stands for a value, and a robot",
                "me get $side | 8:8: $side: a name with $ stands for a value, and a parameter is expected here",
                "argument times = 4 | 8:10: times: there is an argument of that name already",
                "argument se/d = 3 | 8:10: se/d: a name is a letter, then letters, digits and _",
                "argument x | 8:11: behind \"x\" = and the default is missing",
                "argument = 3 | 8:10: =: an argument's name is expected here",
                "argument x = | 8:13: behind \"=\" the default",
                "argument x = 3 4 | 8:16: 4: nothing more is expected behind",
                "argument x = 3miles | 8:14: 3miles: no such unit",
                "argument x = word | 8:14: word: the default is a number, yes, no, on, off, a text in quotes, or one of",
                "argument x = 3mm from 1deg | 8:23: 1deg: not in the unit of the default, mm",
                "argument x = 3 to 1m | 8:19: 1m: not in the unit of the default, which has none",
                "argument x = 3 from 4 to 2 | 8:26: 2: the highest value is less than the lowest",
                "argument x = 3 from 4 | 8:14: x 3: outside 4",
                "argument x = 3 to $times | 8:19: $times: a name with $ stands for a value, and a number is expected"
            })
    void whatIsWrongIsSaidAtItsPlace(String text, String message) {
        parse(ARGUMENTS + text, Map.of());
        assertThat(mistakes).isNotEmpty();
        assertThat(mistakes.get(0).in("f").substring(2)).startsWith(message);
    }

    @Test
    void aWrongDefaultIsTheOnlyMistakeOfAScriptThatUsesIt() {
        parse("argument x = 3mm from 4\nme move $x", Map.of());
        assertThat(mistakes).extracting(Mistake::line).containsExactly(1);
    }

    @Test
    void anArgumentBehindOtherLinesIsRefused() {
        parse("me move 5\nargument x = 3\nrepeat 2\nargument y = 3\nend", Map.of());
        assertThat(mistakes)
                .extracting(Mistake::message)
                .containsOnly("argument: only a script file has arguments, in front of all its other lines")
                .hasSize(2);
    }

    @Test
    void withoutArgumentsAScriptHasNoVariables() {
        parse("me move $x", Map.of());
        assertThat(mistakes.get(0).message())
                .isEqualTo("$x: there is no value of that name; \"let x = VALUE\" makes one");
    }
}
