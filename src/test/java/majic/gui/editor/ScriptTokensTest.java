package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The colours of a line: one letter for each of its pieces. */
class ScriptTokensTest {
    private static final Map<Integer, String> LETTERS = Map.ofEntries(
            Map.entry(ScriptTokens.COMMAND, "c"),
            Map.entry(ScriptTokens.JOINT, "j"),
            Map.entry(ScriptTokens.OWN_COMMAND, "o"),
            Map.entry(ScriptTokens.ROBOT, "r"),
            Map.entry(ScriptTokens.NAME, "n"),
            Map.entry(ScriptTokens.NUMBER, "0"),
            Map.entry(ScriptTokens.TEXT, "t"),
            Map.entry(ScriptTokens.OPEN_TEXT, "!"),
            Map.entry(ScriptTokens.COMMENT, "#"),
            Map.entry(ScriptTokens.SIGN, "."),
            Map.entry(ScriptTokens.VALUE, "v"));

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "1 move 500mm | rc0",
                "1,3 turn -90 until 2 distanceFront < 300 or bumped == yes  # near | r.rc0jrn.0jn.n#",
                "1-4 drive 200 10 for 2.5s | rc00j0",
                "pioneer,1 get now x,y | r.rcjn.n",
                "all.move(0.5m) | r.c.0.",
                "2 set headPan 30 | rcn0",
                "3 beep 2 | ro0",
                "1 act Convoy with 2,3 | rcnjr.r",
                "if not (any distanceFront > 1m and 2 light == on) | cj.rn.0jrn.n.",
                "repeat 4 | c0",
                "    end | c",
                "wait 2s | c0",
                "remove 2 | cr",
                "stop all | cr",
                "add sim:aibo as 1 | cn.nj0",
                "run 'a b.majic | c.nn.n",
                "# only a remark | #",
                "argument far = 300mm | cv.0",
                "1 move $far | rcv",
                "let n = $n + 1 distanceFront | cv.v.rn",
                "let n = min $n (abs 1 x) | cv.ov.orn.",
                "1 move ($n * 100 + 2 distanceFront / 2) | rc.v.0.rn.0.",
                "1 move (rex distanceFront / x) | rc.rn.n.",
                "1.move($n) | r.c.v.",
                "print 'round $n | c.nv",
                "ask far = 300mm from 0 to 2000 for 30s | cv.0j0j0j0",
                "answer 5cm | c0",
                "on 1 x > 150 | crn.0",
                "while (1 x + $n) > 3 and 2 bumped == yes | c.rn.v..0jrn.n",
                "while $n < 2 | cv.0",
                "if ($n + 1) > 3 | c.v.0..0",
                "to square side angle | covv",
                "square 500 $n | o0v",
                "square.stop | r.c"
            })
    void eachPieceHasTheColourOfItsMeaning(String line, String letters) {
        assertThat(ScriptTokens.pieces(line, Set.of("square")).stream()
                        .map(piece -> LETTERS.get(piece.type()))
                        .collect(Collectors.joining()))
                .isEqualTo(letters);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\'',
            value = {"1 act \"a b\" | rct", "run \"a b | c!"})
    void aTextIsOnePieceAndOneThatIsNotClosedIsMarked(String line, String letters) {
        eachPieceHasTheColourOfItsMeaning(line, letters);
    }
}
