package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing that a client sends may harm the server: others are served as before. */
class NastyInputTest {
    private static final String PIECES = "{}()[];,:|&+-*/^!=<>~'\"\\$#.@ \n\u00e9\u0000"
            + "at every loop while if else stop echo wait bin function return group x.y head 1e3 t: +end true 9999999999";

    private final Bench bench = Bench.exact();
    private final Bench.Client nasty = bench.client();

    @RepeatedTest(20)
    void randomBytesAndRandomProgramsDoNoHarm(RepetitionInfo repetition) {
        Random random = new Random(repetition.getCurrentRepetition());
        String[] words = PIECES.split(" ");
        for (int i = 0; i < 300; i++) {
            StringBuilder text = new StringBuilder();
            for (int j = random.nextInt(20); j >= 0; j--) {
                text.append(words[random.nextInt(words.length)]).append(random.nextBoolean() ? " " : "");
                text.append(PIECES.charAt(random.nextInt(40)));
            }
            nasty.ask(text + (random.nextInt(4) == 0 ? ";" : "$$;"), 4);
            nasty.take();
        }

        assertThat(bench.client().ask("1;")).containsExactly("[notag] 1.000000");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "function f() { f() }; f();",
                "function d() { if(1) if(1) if(1) if(1) if(1) if(1) if(1) if(1) { { { { { { { d() } } } } } } } }; d();",
                "function g() { g() & g() }; timeout(100) g();",
                "loop { loop { x = 1 } },",
                "every(0) { every(0) wait(10s) },",
                "group a {b}; group b {a}; a = 1; group a;",
                "x = 1/0; sqrt(-1); head(1); strsub(\"a\",-5,99); [1]*2;",
                "headPan.val->rangemin = 5000; headPan.val = 3 time:-100; headPan'n;",
                "headPan.val = 10 sin:0 ampli:inf, robot.walkspeed = 0; robot.walk(0-inf),",
                "robot.walk(log(0)), robot.turn(\"x\"); robot.walk([1]);",
                "$(1+2) = 4; $(\"a.b\"); x[1/0] = 2; a.b.c = 3;",
                "s = \"0123456789\"; loop { s = s + s },",
                "l = [1]; for (i = 0; i < 40; i++) l = [l, l]; l;",
                "b = camera.val; l = [b]; loop { l = [l, l] },",
                "i = 0; loop { i++; $(\"v\" + i) = camera.val },",
                "every(0) { loop 1, loop 1, loop 1 },",
                "s = \"exec(s) & exec(s)\"; exec(s);",
                "b = bin 99999999999;"
            })
    void aBadProgramDoesNoHarm(String program) {
        nasty.ask("motors on;" + program, 2000);

        assertThat(bench.client().ask("1;")).containsExactly("[notag] 1.000000");
        assertThat(bench.dog().body().pose().xMm()).isFinite();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "(", "[", "-", "!", "1+", "{", "x^", "a:", "f(", "a.b.", "\"", "\\", "if(1)", "1&", "9", "\u00e9",
                "loop "
            })
    void aLongRowOfTheSameDoesNoHarm(String piece) {
        nasty.say(piece.repeat(30_000 / piece.length()) + ";");
        bench.run(32);
        nasty.say(piece.repeat(50_000) + ";");
        bench.run(32);

        assertThat(bench.client().ask("1;")).containsExactly("[notag] 1.000000");
    }
}
