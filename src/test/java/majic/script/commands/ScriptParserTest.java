package majic.script.commands;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import majic.bot.Unit;
import majic.bot.Value;
import majic.script.run.Command;
import majic.script.run.Statement;
import majic.script.syntax.Condition;
import majic.script.syntax.Literal;
import majic.script.syntax.Mistake;
import majic.script.syntax.Scanner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** From text to tree. */
class ScriptParserTest {
    private static final List<String> TYPES = List.of("aibo", "pioneer");

    private static List<Statement> parse(String text) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = ScriptParser.parse(text, TYPES, mistakes);
        assertThat(mistakes).isEmpty();
        return script;
    }

    private static Statement.ForRobots line(String text) {
        return (Statement.ForRobots) parse(text).get(0);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 MOVE 500   # on | 1 / move 500",
                "1.move(500) | 1 / move 500",
                "1 . turn ( -90deg ) | 1 / turn -90deg",
                "1,3-4,aibo drive 100 -20 for 1500ms | 1,3-4,aibo / drive 100 -20 for 1.5s",
                "all.drive(0.1m/s, 20deg/s, until bumped == yes) | all / drive 0.1m/s 20deg/s until bumped == yes",
                "me move 2m until distanceFront < near | me / move 2m until distanceFront < near",
                "2.set(headPan, 30, 500ms) | 2 / set headPan 30 500ms",
                "1 scanLine 2 | 1 / scanLine 2",
                "lab place 1 1m -200 90 | 1 / lab place 1m -200 90",
                "1 set pose 1,-2.5 x=3 | 1 / set pose 1,-2.5 x=3",
                "1 get now x, y,heading | 1 / get now x,y,heading",
                "1 log x,y every 100ms | 1 / log x,y every 100ms",
                "1 log off | 1 / log off",
                "1 act acts/Wander-Dog.act | 1 / act acts/Wander-Dog.act",
                "1 act off | 1 / act off",
                "1 play sounds/bark-2.wav | 1 / play sounds/bark-2.wav",
                "1 help headPan | 1 / help headPan",
                "1 move 1 until not (a < 1 or b > 2) and any c != on | 1 / move 1 until not (a < 1 or b > 2) and any c != on"
            })
    void repeatsALineInItsOwnWords(String text, String words) {
        Statement.ForRobots line = line(text);
        assertThat(line.robots().text() + " / " + line.command().text()).isEqualTo(words);
    }

    @ParameterizedTest
    @CsvSource({
        "move -3, -3, MM",
        "move 2.5cm, 25, MM",
        "move 1m, 1000, MM",
        "turn 3.14159265rad, 180, DEG",
        "turn 90DEG, 90, DEG"
    })
    void bringsNumbersToTheUnitOfAnswers(String command, double amount, Unit unit) {
        Command parsed = line("1 " + command).command();
        Literal number =
                parsed instanceof MotionCommands.Move move ? move.distance() : ((MotionCommands.Turn) parsed).angle();
        Value.Number value = (Value.Number) number.value();
        assertThat(value.amount()).isCloseTo(amount, within(1e-5));
        assertThat(value.unit()).isEqualTo(unit);
    }

    @Test
    void andBindsCloserThanOr() {
        Statement.While loop = (Statement.While)
                parse("while 1 a < 1 or 1 b < 1 and not 1 c < 1\nend").get(0);
        assertThat(loop.condition().sample()).isInstanceOf(Condition.Or.class);
        assertThat(((Condition.Or) loop.condition().sample()).right()).isInstanceOf(Condition.And.class);
    }

    @Test
    void blocksNest() {
        List<Statement> script = parse("repeat\n if 1 a < 1\n  bots\n else\n  repeat 3\n  end\n end\nend\nquit");
        assertThat(script).hasSize(2);
        Statement.If choice =
                (Statement.If) ((Statement.Repeat) script.get(0)).body().get(0);
        assertThat(choice.body()).hasSize(1);
        assertThat(choice.otherwise()).hasSize(1);
    }

    @Test
    void addressesAndFilesNeedNoQuotes() {
        assertThat(parse("add hemisson:/dev/ttyUSB0 as 3\nadd aibo://192.168.1.20:54000\nrun C:\\x\\y-2.majic"))
                .extracting(statement ->
                        ((Statement.ForSession) statement).command().toString())
                .satisfiesExactly(
                        add -> assertThat(add).contains("hemisson:/dev/ttyUSB0").contains("OptionalInt[3]"),
                        add -> assertThat(add).contains("text=aibo://192.168.1.20:54000"),
                        run -> assertThat(run).contains("C:\\x\\y-2.majic"));
    }

    @Test
    void quotesKeepBlanksAndBackslashes() {
        ParameterCommands.Own own = (ParameterCommands.Own)
                line("1 play \"my sounds\\bark # 1.wav\" 3").command();
        assertThat(own.arguments().get(0).value()).isEqualTo(Value.text("my sounds\\bark # 1.wav"));
        assertThat(own.arguments()).hasSize(2);
    }

    @Test
    void afterAMistakeItGoesOnWithTheNextLine() {
        List<Mistake> mistakes = new ArrayList<>();
        ScriptParser.parse("1 move\nrepeat x\n  2 trun(\nend\nend\n3.turn()\nwhile\nend", TYPES, mistakes);
        assertThat(mistakes)
                .extracting(mistake -> mistake.line() + ":" + mistake.column())
                .containsExactly("1:7", "2:8", "3:10", "5:1", "6:8", "7:6");
    }

    @Test
    void keepsThePlaceOfEachToken() {
        assertThat(Scanner.scan("1 move 5m\n  \"x y\"#c"))
                .extracting(token -> token.line() + ":" + token.column() + token.kind())
                .containsExactly(
                        "1:1NUMBER", "1:3WORD", "1:8NUMBER", "1:10NEWLINE", "2:3QUOTED", "2:8NEWLINE", "2:10END");
    }

    /** A word without a rule would be taken for a command that only some type of robot has. */
    @Test
    void eachWordThatHelpDescribesHasARule() {
        assertThat(LineParser.COMMAND_WORDS)
                .isNotEmpty()
                .allSatisfy(word -> assertThat(statements("1 " + word + " 1"))
                        .noneMatch(statement -> statement instanceof Statement.ForRobots line
                                && line.command() instanceof ParameterCommands.Own));
        assertThat(SessionParser.WORDS)
                .isNotEmpty()
                .allSatisfy(word ->
                        assertThat(statements(word)).allMatch(statement -> statement instanceof Statement.ForSession));
    }

    private static List<Statement> statements(String text) {
        return ScriptParser.parse(text, TYPES, new ArrayList<>());
    }
}
