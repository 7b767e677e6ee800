package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import majic.act.Sources;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the arguments of acts in a session: given in a line, checked when it is typed, used by the act, saved. */
class ActArgumentsInSessionTest {
    private static final String STEPS = """
            import majic.act.Argument;
            import majic.act.MajicAct;
            import majic.bot.Unit;

            public class Steps extends MajicAct {
                @Argument(value = "how far a step goes", unit = Unit.MM, from = 10, to = 500)
                private double length = 100;

                @Argument(value = "how many steps", from = 1)
                private int count = 2;

                @Override
                protected void behave() {
                    for (int step = 0; step < count; step++) {
                        bot.move(length);
                    }
                }
            }
            """;

    private static final List<String> PATROL = List.of(
            "# Goes there",
            "# and turns.",
            "argument far = 0.5m from 100 to 2000 \"how far it goes\"",
            "argument sit = yes",
            "me move $far",
            "me turn 90");

    @TempDir
    private static Path folder;

    private static byte[] steps;

    @AutoClose
    private ScriptFixture fixture;

    @BeforeEach
    void open() throws IOException {
        steps = steps == null ? Sources.act(folder, "Steps", STEPS) : steps;
        Path file = Files.write(folder.resolve("Steps.act"), steps);
        Files.write(folder.resolve("rounds.majic"), PATROL);
        fixture = new ScriptFixture(new ActCatalog(folder, Sources.trusting(ActFile.read(file))));
        fixture.add(fixture.aibo);
        fixture.add(fixture.pioneer);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 act Steps | move 100,move 100",
                "1 act Steps count=1 | move 100",
                "1 act Steps length=20cm COUNT=1 | move 200",
                "1 act Steps length = 300 count = 3 | move 300,move 300,move 300",
                "1.act(Steps, length=300, count=1) | move 300",
                "1 act rounds | move 500,turn 90",
                "1 act rounds far=1m | move 1000,turn 90"
            })
    void theActUsesTheValuesOfItsLine(String line, String sent) throws InterruptedException {
        assertThat(fixture.runPipe(line)).noneMatch(answer -> answer.contains("failed"));
        assertThat(fixture.bot(1).sent()).startsWith(sent.split(","));
        assertThat(fixture.bot(1).sent().stream().filter(one -> one.matches("(move|turn) .*")))
                .containsExactly(sent.split(","));
    }

    @Test
    void anArgumentIsComputed() throws InterruptedException {
        assertThat(fixture.runPipe(
                        "let n = 3",
                        "1 act Steps length=(20 * $n) count=$n",
                        "1 wait",
                        "2 act rounds far=(2 x + 300)",
                        "2 wait"))
                .contains("1 act Steps length=60 count=3: done (0.6 s)")
                .anyMatch(line -> line.startsWith("2 act rounds far=300mm: done"));
        assertThat(fixture.bot(1).state().pose().xMm()).isEqualTo(180);
    }

    @Test
    void theAnswerRepeatsThem() throws InterruptedException {
        assertThat(fixture.runPipe("1 act Steps length=200 count=1"))
                .anyMatch(line -> line.startsWith("1 act Steps length=200 count=1: done"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 act Steps lenght=200 | lenght: the act has no such argument; did you mean length?",
                "1 act rounds speed=200 | speed: the act has no such argument; it takes far, sit",
                "1 act Steps length=5 | length 5: outside 10 … 500 mm",
                "1 act Steps length=5deg | length 5 deg: not in mm",
                "1 act Steps count=1.5 | count 1.5: not a whole number",
                "1 act Steps count=many | count many: not a number",
                "1 act Steps count=1 count=2 | count: given twice",
                "1 act Steps count= | behind \"=\" a value for count is missing",
                "1 act Steps count==1 | ==: = is expected here",
                "1 act rounds far=5 | far 5: outside 100 … 2000 mm",
                "1 act rounds sit=2 | sit 2: it is yes or no",
                "1 act Steps with 2 count=1 | count: write arguments in front of \"with\"",
                "1 act Guard near=3 | near: the act has no such argument; it takes none"
            })
    void aWrongOneIsRefusedBeforeAnythingMoves(String line, String why) throws InterruptedException {
        assertThat(fixture.refusal(line)).contains(why);
        assertThat(fixture.bot(1).sent()).isEmpty();
    }

    @Test
    void aValueThatTheScriptCannotUseIsRefusedWithItsPlace() throws Exception {
        Files.writeString(folder.resolve("often.majic"), "argument times = 3\nrepeat $times\n  me turn 90\nend\n");
        assertThat(fixture.refusal("1 act often times=2.5"))
                .get()
                .asString()
                .contains("often.majic:2:8: 2.5: how often, a whole number, is expected here");
    }

    @Test
    void aRunFileHasItsDefaults() throws Exception {
        Path file = Files.writeString(folder.resolve("run.majic"), "argument far = 300\n1 move $far\n");
        fixture.runPipe("run \"" + file + '"');
        assertThat(fixture.bot(1).sent()).contains("move 300");
    }

    @Test
    void aRobotThatRunsTheActShowsThem() throws InterruptedException {
        fixture.prompt.parseText("1 act Steps length=200 count=50");
        fixture.pause(1);
        fixture.prompt.parseText("bots");
        fixture.prompt.parseText("1 stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).anyMatch(line -> line.endsWith("running Steps length=200mm count=50"));
    }

    @Test
    void aSavedSessionRepeatsThem() throws Exception {
        fixture.runPipe("1 act Steps length=200 count=1");
        Path saved = folder.resolve("saved.majic");
        fixture.runPipe("save session \"" + saved + '"');
        assertThat(Files.readAllLines(saved)).contains("1 act Steps length=200 count=1");
    }

    @Test
    void theCommentAtTheHeadOfAScriptDescribesIt() throws InterruptedException {
        assertThat(fixture.session.offers().find("rounds").details().description())
                .isEqualTo("Goes there and turns.");
        assertThat(fixture.runPipe("acts")).contains("acts: rounds (me): Goes there and turns. Arguments: far, sit.");
    }

    @Test
    void theLineOfAnOfferHasWhatDiffersFromTheDefaults() {
        ActOffer offer = fixture.session.offers().find("Steps");
        Value far = Value.of(200, Unit.MM);
        Value two = Value.of(2, Unit.NONE);
        assertThat(offer.line(1, Map.of("length", far, "count", two), List.of()))
                .isEqualTo("1 act Steps length=200mm");
        assertThat(offer.line(1, Map.of(), List.of(2, 3))).isEqualTo("1 act Steps with 2,3");
    }

    @Test
    void theDescriptionOfAnActListsThemAll() throws InterruptedException {
        assertThat(fixture.runPipe("acts rounds", "acts Steps"))
                .containsSubsequence(
                        "acts: rounds: Goes there and turns.",
                        "acts: rounds: needs me",
                        "acts: rounds: takes far = 500mm from 100 to 2000 \"how far it goes\"",
                        "acts: rounds: takes sit = yes \"\"",
                        "acts: Steps: takes length = 100mm from 10 to 500 \"how far a step goes\"",
                        "acts: Steps: takes count = 2 whole from 1 \"how many steps\"");
        assertThat(fixture.refusal("acts Stops")).get().asString().contains("there is no act Stops");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 act Steps | count= length= with",
                "1 act Steps length=200 | count= with",
                "1 act Steps length= | 100mm",
                "1 act rounds sit= | no yes",
                "1 act Nothing  | with"
            })
    void aLineIsCompletedWithThem(String line, String words) {
        String typed = line.endsWith("=") ? line : line + " ";
        assertThat(fixture.prompt.complete(typed, typed.length()).words()).containsExactly(words.split(" "));
    }

    @Test
    void aCompletionNamesUnitRangeDefaultAndPurpose() {
        assertThat(fixture.prompt
                        .complete("1 act Steps le", 14)
                        .entries()
                        .get(0)
                        .inWords())
                .isEqualTo("length= 10 … 500 mm, default 100 mm: how far a step goes");
        assertThat(fixture.prompt
                        .complete("1 act Steps length=", 19)
                        .entries()
                        .get(1)
                        .inWords())
                .isEqualTo("length: how far a step goes (10 … 500 mm)");
    }
}
