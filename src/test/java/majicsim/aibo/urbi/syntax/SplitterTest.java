package majicsim.aibo.urbi.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where a command ends (URBI sheet, section 3). */
class SplitterTest {
    private final Splitter splitter = new Splitter();

    @ParameterizedTest
    @CsvSource(
            delimiter = '~',
            value = {
                "1;2,3; ~ 1;~2,~3;",
                "'\"a;b\\\";c\";x;' ~ '\"a;b\\\";c\";'~x;~",
                "[1,2];f(1,2;3); ~ [1,2];~f(1,2;3);~",
                "{ 1; 2 };4; ~ { 1; 2 };~4;~",
                "/* ; \" */ 5;6; ~ /* ; \" */ 5;~6;~",
                "};7; ~ };~7;~",
                "(1;$$8; ~ 8;~~"
            })
    void endsAtASemicolonOrCommaOutsideBracketsAndQuotes(String text, String first, String second, String third) {
        List<String> wanted = new ArrayList<>(Arrays.asList(first, second, third));
        wanted.removeIf(part -> part == null || part.isEmpty());

        assertThat(split(text, text.length())).containsExactlyElementsOf(wanted);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 64})
    void findsTheSameCommandsHoweverTheBytesArrive(int chunkSize) {
        String text = "a: 1+1; // c;\n\"x;y\", { b; c };\n# d,\n/* ; */ [1,2]; /* **/ f(\"(\");";

        assertThat(split(text, chunkSize)).isEqualTo(split(text, text.length())).hasSize(5);
    }

    @Test
    void aCommentRunsToTheEndOfItsLine() {
        assertThat(split("# 1;\n2;// 3;", 1)).containsExactly("# 1;\n2;");
    }

    @Test
    void losesOneCommandThatIsTooLongAndNoMore() {
        splitter.feed(("\"" + "a".repeat(Splitter.LIMIT)).getBytes(StandardCharsets.ISO_8859_1));
        assertThat(splitter.next()).isNull();
        assertThat(splitter.overflowed()).isTrue();
        assertThat(splitter.overflowed()).isFalse();

        assertThat(split("b;\";2;", 3)).containsExactly("2;");
    }

    @Test
    void handsOutBytesBehindACommandAsTheyAre() {
        splitter.feed("b=bin 5;he".getBytes(StandardCharsets.ISO_8859_1));
        assertThat(splitter.next()).isEqualTo("b=bin 5;");
        assertThat(splitter.take(5)).isNull();

        splitter.feed(";l\"7;".getBytes(StandardCharsets.ISO_8859_1));

        assertThat(splitter.take(5)).asString().isEqualTo("he;l\"");
        assertThat(splitter.next()).isEqualTo("7;");
    }

    private List<String> split(String text, int chunkSize) {
        List<String> commands = new ArrayList<>();
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        for (int from = 0; from < bytes.length; from += chunkSize) {
            splitter.feed(Arrays.copyOfRange(bytes, from, Math.min(bytes.length, from + chunkSize)));
            for (String next = splitter.next(); next != null; next = splitter.next()) {
                commands.add(next);
            }
        }
        return commands;
    }
}
