package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Values with names, expressions, procedures. */
class ComputingTest {
    @TempDir
    private Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    1 + 2 * 3                    | 7
                    (1 + 2) * 3                  | 9
                    10 - 4 - 3                   | 3
                    10 -4                        | 6
                    7 / 2                        | 3.5
                    -3 + 1                       | -2
                    2m + 30cm                    | 2300 mm
                    300mm - 100                  | 200 mm
                    600mm / 2                    | 300 mm
                    600mm / 200mm                | 3
                    200mm/s * 3s                 | 600 mm
                    600mm / 3s                   | 200 mm/s
                    600mm / 200mm/s              | 3 s
                    min 3 2                      | 2
                    max 3mm (1m / 2)             | 500 mm
                    abs (2 - 5)                  | 3
                    clear                        | clear
                    clear + 5mm                  | clear
                    min clear 300mm              | 300 mm
                    max clear 300mm              | clear
                    searching                    | searching
                    "two words"                  | two words
                    1 x                          | 0 mm
                    1 x + 500                    | 500 mm
                    distance 1 2                 | 0 mm
                    random 3 3                   | 3
                    """)
    void anExpressionIsComputed(String expression, String value) throws InterruptedException {
        fixture.prompt.parseText("let n = " + expression);
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).containsExactly("n = " + value);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    let n = 1mm + 1deg           | +: mm and deg cannot be added
                    let n = 1mm * 1mm            | *: mm times mm has no unit here
                    let n = 1 / 0                | /: nothing can be divided by 0
                    let n = 1 / (1 - 1)          | /: nothing can be divided by 0
                    let n = yes + 1              | +: yes is not a number
                    let n = $m                   | $m: there is no value of that name; "let m = VALUE" makes one
                    let n = 5 - clear            | -: clear, nothing in range, cannot be subtracted
                    let n = 5-3                  | 5-3: write blanks around a minus, as in 5 - 3
                    let n =                      | behind "=" a value (a number, $name, a robot and its parameter, a bracket) is missing
                    let n = (1                   | behind "1" ")" is missing
                    let n = 1 sonarr             | sonarr: robot 1 (Aibo) has no such parameter
                    let n = all x                | all: a value is read from one robot; write its number in front
                    1 move (1 x + 90deg)         | +: mm and deg cannot be added
                    1 move (90deg)               | (90deg) is 90deg: a distance is expected here (mm, cm, m)
                    """)
    void whatCannotBeComputedIsSaid(String line, String message) throws InterruptedException {
        assertThat(fixture.refusal(line)).get().asString().startsWith(message);
    }

    @Test
    void aNameKeepsItsValueForTheLinesBehind() throws InterruptedException {
        assertThat(fixture.runPipe("let side = 200mm", "1 move ($side + 100)", "1 move -$side", "1 get x"))
                .containsExactly(
                        "1 move 300mm: done (300 mm, 1.0 s)", "1 move -200mm: done (-200 mm, 0.7 s)", "1 x = 100 mm");
    }

    @Test
    void aReadingIsReadWhenTheLineRuns() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300", "1 move (600 - 1 x)", "1 move (x / 2)"))
                .containsExactly(
                        "1 move 300: done (300 mm, 1.0 s)",
                        "1 move 300mm: done (300 mm, 1.0 s)",
                        "1 move 300mm: done (300 mm, 1.0 s)");
    }

    @Test
    void aLoopCounts() throws InterruptedException {
        assertThat(fixture.runPipe(
                        "let n = 0",
                        "while $n < 3",
                        "let n = $n + 1",
                        "1 move (100 * $n)",
                        "end",
                        "print done with $n"))
                .contains(
                        "1 move 100: done (100 mm, 0.3 s)",
                        "1 move 200: done (200 mm, 0.7 s)",
                        "1 move 300: done (300 mm, 1.0 s)",
                        "done with 3");
    }

    @Test
    void aProcedureHasArguments() throws InterruptedException {
        assertThat(fixture.runPipe(
                        "to corner side angle",
                        "1 move $side",
                        "1 turn $angle",
                        "end",
                        "corner 300 90",
                        "corner (100 + 50) -45"))
                .contains(
                        "1 move 300: done (300 mm, 1.0 s)",
                        "1 turn 90: done (90 deg, 1.0 s)",
                        "1 move 150: done (150 mm, 0.5 s)");
    }

    @Test
    void aProcedureThatCallsItselfForEverIsEnded() throws InterruptedException {
        assertThat(fixture.runPipe("to again", "again", "end", "again"))
                .anyMatch(line -> line.contains("procedures call each other too deeply (50)"));
    }

    @Test
    void inTheLabRandomNumbersAreTheSameInEachRun() throws InterruptedException {
        List<String> first = fixture.runPipe("print (random 1 1000000)", "print (random 1 1000000)");
        try (ScriptFixture again = ScriptFixture.withTwo()) {
            assertThat(again.runPipe("print (random 1 1000000)", "print (random 1 1000000)"))
                    .isEqualTo(first);
        }
        assertThat(first.get(0)).isNotEqualTo(first.get(1));
    }

    @Test
    void aConditionComparesWhatWasKept() throws InterruptedException {
        assertThat(fixture.runPipe(
                        "let side = left",
                        "if $side == left and ($side != right or 1 > 2)",
                        "1 move 30",
                        "else",
                        "1 move 60",
                        "end"))
                .contains("1 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void aMotionEndsByWhatWasKept() throws InterruptedException {
        assertThat(fixture.runPipe("let far = 100", "1 move 300 until x > ($far * 2)"))
                .anyMatch(line -> line.startsWith("1 move 300 until x > 200: done (2"));
    }

    @Test
    void aValueOfABlockEndsWithIt() throws InterruptedException {
        assertThat(fixture.runPipe("repeat 1", "let inner = 3", "end", "print $inner"))
                .contains("$inner: there is no value of that name; \"let inner = VALUE\" makes one");
    }

    @Test
    void aNameKeepsItsKind() throws InterruptedException {
        fixture.runPipe("let n = 3mm");
        assertThat(fixture.pipe.parseText("let n = 3deg"))
                .contains("n: it is a number of mm and cannot become a number of deg");
    }

    @Test
    void aSavedSessionHasTheValues() throws InterruptedException {
        fixture.runPipe("let n = 100", "1 move ($n * 3)", "repeat 1", "1 move $n", "end");
        assertThat(fixture.session.state().record().lines())
                .contains("1 move 300", "1 move 100")
                .noneMatch(line -> line.contains("$"));
    }

    @Test
    void stopEndsAQuestion() throws InterruptedException {
        fixture.prompt.parseText("ask far = 300mm for 1000s");
        fixture.pause(1);
        fixture.prompt.parseText("stop");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).anyMatch(line -> line.startsWith("ask far = 300mm for 1000s: stopped"));
        assertThat(fixture.session.state().questions().open()).isEmpty();
    }

    @Test
    void anActComputes() throws InterruptedException {
        ScriptAct act = new ScriptAct("there.majic", """
                argument side = 100mm
                to leg mm
                  me move $mm
                end
                let n = 1
                while $n <= 2
                  leg ($n * $side + 2 x)
                  let n = $n + 1
                end
                """);
        assertThat(act.roles()).hasSize(2);
        assertThat(act.roles().get(1).parameters()).contains("x");
    }

    @Test
    void aQuestionIsAnswered() throws InterruptedException {
        fixture.prompt.parseText("ask far = 300mm from 0 to 2000 \"How far?\" for 10s");
        fixture.pause(1);
        assertThat(fixture.prompt.parseText("answer 3m")).contains("far 3000 mm: outside 0 … 2000 mm");
        fixture.prompt.parseText("answer 50cm");
        fixture.prompt.awaitAll();
        fixture.prompt.parseText("1 move $far");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("1 move 500mm: done (500 mm, 1.7 s)");
    }

    @Test
    void aProgramAtASocketAnswersItsOwnQuestion() throws InterruptedException {
        MajicParser socket = MajicParser.socket(fixture.session);
        socket.parseText("ask far = 300mm \"How far?\" for 10s");
        socket.parseText("1 move $far");
        fixture.pause(1);
        socket.parseText("answer 60mm");
        socket.awaitAll();
        assertThat(fixture.answers()).contains("1 move 60mm: done (60 mm, 0.2 s)");
    }

    @Test
    void aQuestionWithoutAnAnswerTakesTheDefault() throws InterruptedException {
        assertThat(fixture.runPipe("ask far = 300mm \"How far?\" for 10s", "1 move $far"))
                .contains("How far? no answer, 300 mm", "1 move 300mm: done (300 mm, 1.0 s)");
    }

    @Test
    void aBlockRunsEachTimeItsConditionBecomesTrue() throws InterruptedException {
        assertThat(fixture.runPipe(
                        "repeat 1",
                        "on 1 x > 150",
                        "print passed",
                        "end",
                        "1 move 300",
                        "wait",
                        "1 move -300",
                        "wait",
                        "1 move 300",
                        "wait",
                        "end"))
                .filteredOn("passed"::equals)
                .hasSize(2);
    }

    /** The line waits for robot 2 before it moves robot 1; the stop comes from the same prompt. */
    @ParameterizedTest
    @ValueSource(strings = {"1 stop", "stop"})
    void aStopRevokesALineThatStillReads(String stop) throws InterruptedException {
        fixture.prompt.parseText("2 move 3000");
        fixture.prompt.parseText("1 move (2 x)");
        fixture.pause(1);
        fixture.prompt.parseText(stop);
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).contains("1 move (2 x): not run: stopped");
    }

    @Test
    void aWrongLineDoesNotMakeAName() throws InterruptedException {
        assertThat(fixture.refusal("let n = 5mm 3")).isPresent();
        assertThat(fixture.refusal("let n = 90deg")).isEmpty();
    }

    @Test
    void aNameKeepsItsKindAlsoFromAReading() throws InterruptedException {
        fixture.runPipe("let n = 3mm");
        assertThat(fixture.pipe.parseText("let n = 1 heading"))
                .contains("n: it is a number of mm and cannot become a number of deg");
    }

    @Test
    void aNumberTakesTheUnitOfTheName() throws InterruptedException {
        assertThat(fixture.runPipe("let n = 3mm", "let n = 4", "print $n ($n / 2mm)"))
                .containsExactly("4 mm 2");
    }

    @Test
    void aLengthMayBecomeClear() throws InterruptedException {
        assertThat(fixture.runPipe("let n = 3mm", "let n = clear", "print $n", "let n = 2mm", "print $n"))
                .containsExactly("clear", "2 mm");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    1m / 3                       | 1 move 333.333mm: done (333 mm, 1.1 s)
                    0.1 + 0.2                    | 1 move 0.3: done (0.3 mm, 0.0 s)
                    0.1 + 0.2 - 0.3              | 1 move 0: done (0 mm, 0.0 s)
                    0.00002 * 0.5                | 1 move 0.00001: done (0 mm, 0.0 s)
                    """)
    void aLineHasTheDigitsThatCount(String distance, String answer) throws InterruptedException {
        assertThat(fixture.runPipe("1 move (" + distance + ")")).containsExactly(answer);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    repeat (2 - 5)               | -3: nothing can be repeated less than 0 times
                    repeat (5 / 2)               | 2.5: how often, a whole number, is expected here
                    repeat (1 x)                 | (1 x): how often, a whole number, is expected here
                    wait (1 x)                   | (1 x): a time (s, ms) is expected here
                    wait (1 moving)              | (1 moving): nothing more is expected behind "wait"
                    1 move (1 heading)           | (1 heading): a distance (mm, cm, m) is expected here
                    """)
    void whatDoesNotFitIsFoundBeforeTheRun(String line, String message) throws InterruptedException, IOException {
        String end = line.startsWith("repeat") ? "end" : "";
        assertThat(runFile("1 move 300", "repeat 1", line, end, "end"))
                .hasSize(2)
                .first()
                .asString()
                .endsWith(":3:" + (line.indexOf('(') + 1) + ": " + message);
    }

    /** A procedure is checked where it is called, since the team may be another one there. */
    @Test
    void aProcedureMayCommandARobotThatIsAddedBeforeItsCall() throws InterruptedException, IOException {
        assertThat(runFile("to go", "3 move 30", "end", "add sim:aibo", "go"))
                .contains("3 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void aProcedureThatIsNotCalledIsChecked() throws InterruptedException, IOException {
        assertThat(runFile("to go", "3 move 30", "end", "1 move 30").get(0))
                .endsWith(":2:1: 3: there is no robot 3 (robots: 1 Aibo, 2 Pioneer)");
    }

    @Test
    void aChainOfCallsMayBeAsLongAsAScript() throws InterruptedException, IOException {
        List<String> lines = new ArrayList<>();
        for (int number = 0; number < 20_000; number++) {
            lines.addAll(List.of("to p" + number, "p" + (number + 1), "end"));
        }
        lines.addAll(List.of("to p20000", "1 move 30", "end", "p19990"));
        assertThat(runFile(lines.toArray(String[]::new))).contains("1 move 30: done (30 mm, 0.1 s)");
    }

    private List<String> runFile(String... lines) throws InterruptedException, IOException {
        Path file = Files.write(folder.resolve("script.majic"), List.of(lines));
        return fixture.runPipe("run \"" + file + '"');
    }

    @Test
    void yesIsAWordAlsoInALineForARobot() throws InterruptedException {
        assertThat(fixture.refusal("1 set light (yes)")).isEmpty();
    }

    @Test
    void aConditionThatIsReachedAgainIsWatchedOnce() throws InterruptedException {
        assertThat(fixture.runPipe("repeat 3", "on 1 x > 50", "print near", "end", "1 move 100", "wait", "end"))
                .filteredOn("near"::equals)
                .hasSize(1);
    }

    @Test
    void aSavedSessionRepeatsWhatChanceAndAPersonChose() throws InterruptedException {
        fixture.runPipe("repeat 1", "let d = 10 + (random 3 3)", "ask e = 5mm for 1s", "1 move ($d + $e)", "end");
        assertThat(fixture.session.state().record().lines())
                .contains("1 move 18mm")
                .noneMatch(line -> line.startsWith("repeat"));
    }

    @Test
    void aCallInManyBlocksThatNeverEndsIsEnded() throws InterruptedException {
        List<String> lines = new ArrayList<>(List.of("to again"));
        lines.addAll(Collections.nCopies(45, "repeat 1"));
        lines.add("again");
        lines.addAll(Collections.nCopies(46, "end"));
        lines.add("again");
        assertThat(fixture.runPipe(lines.toArray(String[]::new)))
                .anyMatch(line -> line.contains("procedures call each other too deeply (500 blocks)"));
    }

    /** A message with all of them would be too long. */
    @Test
    void aMessageListsSomeOfManyNames() throws InterruptedException {
        for (int name = 0; name < 30; name++) {
            fixture.prompt.parseText("let many" + name + " = 1");
        }
        assertThat(fixture.refusal("print $other")).get().asString().endsWith("many26 …)");
    }
}
