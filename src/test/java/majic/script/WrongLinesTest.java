package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a wrong line has no effect, and that the answer names what is wrong, where, and what would be right. */
class WrongLinesTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "1 get headPam | headPam: robot 1 (Aibo) has no such parameter; did you mean headPan?",
                "1 set headPan 120 | headPan 120: outside -91 … 91 deg",
                "7 move 100 | 7: there is no robot 7 (robots: 1 Aibo, 2 Pioneer)",
                "1,7 move 100 | 7: there is no robot 7 (robots: 1 Aibo, 2 Pioneer)",
                "5-9 move 100 | 5-9: there is no such robot (robots: 1 Aibo, 2 Pioneer)",
                "me move 100 | me: only an act has a robot of its own; write its number",
                "move 100 | move: which robot? Write its number in front, as in \"1 move\"",
                "bobs | bobs: no such command or robot; did you mean bots?",
                "1 mvoe 100 | mvoe: robot 1 (Aibo) has no such command; did you mean move?",
                "1 headPan 30 | headPan: a parameter; read it with get, or change it with set",
                "1 fly | fly: robot 1 (Aibo) has no such command",
                "1 move | behind \"move\" a distance (mm, cm, m) is missing",
                "1 move fast | fast: a distance (mm, cm, m) is expected here",
                "1 move 90deg | 90deg: a distance is expected here (mm, cm, m)",
                "1 move 5km | 5km: no such unit (there are mm, cm, m, deg, rad, mm/s, m/s, deg/s, rad/s, mm/s², m/s², deg/s², s, ms, V, %, °C)",
                "1 move 500 600 | 600: nothing more is expected behind \"1 move 500\"",
                "1 move 9000 | move 9000: longer than maxMove, 5000 mm; set maxMove higher to allow it",
                "1 turn 99999 | turn 99999: not an angle of at most 36000 deg",
                "1 drive 1900 0 | drive 1900: outside -1000 … 1000 mm/s",
                "1 drive 100 | behind \"100\" a turn rate (deg/s, rad/s) is missing",
                "1 drive 100 10 for 90s | drive … for 90 s: outside 0 … 60 s",
                "1 move 1m until | behind \"until\" a parameter is missing",
                "1 move 1m until distanceFront | behind \"distanceFront\" one of < <= > >= == != is missing",
                "1 move 1m until distanceFront = 3 | =: write == to compare",
                "1 move 1m until bumped < 3 | bumped 3: it is yes or no",
                "1 move 1m until posture == lay | posture lay: it is one of stand, sit",
                "1 move 1m until (bumped == yes | behind \"yes\" \")\" is missing",
                "1 get | behind \"get\" a parameter is missing",
                "1 set headPan | behind \"headPan\" a value is missing",
                "1 set x 3 | x: can be read but not set",
                "1 set light maybe | light maybe: it is on or off",
                "1 set posture lie | posture lie: it is one of stand, sit",
                "1 wag 3 4 | wag: takes TIMES",
                "1 bark gladly | bark: takes MOOD TIME [TIME]...",
                "1 bark wildly 100ms | mood wildly: it is one of gladly, sadly",
                "1 bark sadly 100ms 300ms 2s | time 2000 ms: outside 0 … 1000 ms",
                "1 bark sadly -5ms | time -5 ms: outside 0 … 1000 ms",
                "1 bark sadly 200 | 200: the unit of the time is missing; write 200ms or 200s",
                "1 bark sadly 200ms -1.5 | -1.5: the unit of the time is missing; write -1.5ms or -1.5s",
                "1 move 1m until age > 500 | 500: the unit of the time is missing; write 500ms or 500s",
                "1 move 1,5m | 1,5m: a number has a decimal point; write 1.5m",
                "1.move(1,5m) | 1,5m: a number has a decimal point; write 1.5m",
                "1 turn -0,5rad | -0,5rad: a number has a decimal point; write -0.5rad",
                "1 drive 0,1m/s 20 | 0,1m/s: a number has a decimal point; write 0.1m/s",
                "1 drive 100 20 for 1,5s | 1,5s: a number has a decimal point; write 1.5s",
                "1 move 1m until distanceFront < 0,3m | 0,3m: a number has a decimal point; write 0.3m",
                "1 set near 0,3m | near 0,3m: a number has a decimal point; write 0.3m",
                "1 log x every 0,5s | 0,5s: a number has a decimal point; write 0.5s",
                "wait 1,5s | 1,5s: a number has a decimal point; write 1.5s",
                "1 set headPan 0 -5ms | time -0.005 s: outside 0 … 10 s",
                "1 act WandrDog | there is no act WandrDog; did you mean WanderDog? \"acts\" lists those there are, and a file's name ends in .act or .majic",
                "1 log x | behind \"x\" \"every\" and a time is missing",
                "1 log x every 1ms | 1ms: the log takes from 10 ms to one day between readings",
                "1.move 500 | 500: \"(\" is expected here",
                "1.move(500 | behind \"500\" \")\" is missing",
                "1 \"move | \"move: the quote is not closed",
                "wait 2 | 2: the unit is required, for instance \"wait 2s\"",
                "wait -2s | -2s: time does not run backward",
                "add sausage | sausage: not a robot's address; it looks like pioneer://10.0.0.5:8101, hemisson:COM3 or sim:aibo",
                "add pionier://x | pionier: no such type of robot (there are aibo, pioneer); did you mean pioneer?",
                "add aibo://x as 2 | 2: there is a robot 2 already",
                "run nowhere.majic | nowhere.majic: there is no such file",
                "save nothing | nothing: \"session\", \"log\" or \"team\" is expected here",
                "help towels | towels: no help on that; \"acts towels\" describes an act",
                "end | end: no block is open here",
                "else | else: there is no if in front of it",
                "repeat often | often: how often, a whole number, is expected here",
                "while distanceFront > 3 | distanceFront: of which robot? Write its number in front",
                "1.5 move 3 | 1.5: a robot's number is expected here",
                "% | %: a robot (a number, a name, a range, a type, all) is expected here"
            })
    void isRefusedWithASentence(String line, String sentence) throws InterruptedException {
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            assertThat(fixture.refusal(line)).hasValue(sentence);
            assertThat(fixture.answers()).containsExactly(sentence);
            assertThat(fixture.bot(1).sent()).isEmpty();
            assertThat(fixture.prompt.totalCommands()).isZero();
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 mvoe 100 | mvoe",
                "1,7 move 100 | 7",
                "bobs | bobs",
                "1 move fast | fast",
                "1 set headPan 120 | 120",
                "1 move 1m until bumpd == yes | bumpd",
                "add sausage://x | sausage://x",
                "1 act WandrDog | WandrDog",
                "run nowhere.majic | nowhere.majic",
                "1 act \"no such act\" | \"no such act\"",
                "1 \"move | \"move",
                "1 move | ''",
                "1 move 9000 | 9000"
            })
    void aRefusalHasThePlaceOfTheWrongWord(String line, String word) throws InterruptedException {
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            assertThat(fixture.refused(line)).hasValueSatisfying(refusal -> {
                assertThat(line.substring(refusal.from(), refusal.to())).isEqualTo(word);
                assertThat(refusal.from()).isEqualTo(word.isEmpty() ? line.length() : line.indexOf(word));
            });
        }
    }

    @Test
    void aLineOfSeveralIsRefusedWithItsNumber() {
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            assertThat(fixture.pipe.parseLine(3, "1 get x")).isEmpty();
            assertThat(fixture.pipe.parseLine(4, "7 move 100"))
                    .hasValueSatisfying(why -> assertThat(why).startsWith("line 4: 7: there is no robot 7"));
            assertThat(fixture.pipe.parseLine(5, "7 stop"))
                    .hasValueSatisfying(why -> assertThat(why).startsWith("line 5: taken as STOP: 7: "));
        }
    }
}
