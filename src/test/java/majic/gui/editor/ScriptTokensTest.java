package majic.gui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The colours of a line: one letter for each of its pieces. */
class ScriptTokensTest {
    private static final Map<Integer, String> LETTERS = Map.of(
            ScriptTokens.COMMAND, "c",
            ScriptTokens.JOINT, "j",
            ScriptTokens.OWN_COMMAND, "o",
            ScriptTokens.ROBOT, "r",
            ScriptTokens.NAME, "n",
            ScriptTokens.NUMBER, "0",
            ScriptTokens.TEXT, "t",
            ScriptTokens.OPEN_TEXT, "!",
            ScriptTokens.COMMENT, "#",
            ScriptTokens.SIGN, ".");

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
                "# only a remark | #"
            })
    void eachPieceHasTheColourOfItsMeaning(String line, String letters) {
        assertThat(ScriptTokens.pieces(line).stream()
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
