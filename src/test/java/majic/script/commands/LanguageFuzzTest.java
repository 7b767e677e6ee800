package majic.script.commands;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majic.script.run.Statement;
import majic.script.syntax.Mistake;
import majic.text.OneSentence;

/** Arbitrary scripts: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see CONTRIBUTING.md). */
class LanguageFuzzTest {
    private static final List<String> WORDS = List.of("aibo", "pioneer");

    @FuzzTest
    void everyMistakeHasItsPlace(byte[] bytes) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        String[] lines = text.split("\\R", -1);

        List<Mistake> mistakes = new ArrayList<>();
        ScriptParser.parse(text, WORDS, mistakes);

        for (Mistake mistake : mistakes) {
            assertThat(mistake.line()).isBetween(1, lines.length);
            assertThat(mistake.column()).isBetween(1, lines[mistake.line() - 1].length() + 1);
            OneSentence.check(mistake.message());
        }
    }

    @FuzzTest
    void aCommandIsWrittenAsItWasRead(byte[] bytes) {
        List<Mistake> mistakes = new ArrayList<>();
        List<Statement> script = ScriptParser.parse(new String(bytes, StandardCharsets.UTF_8), WORDS, mistakes);
        for (Statement statement : script) {
            if (mistakes.isEmpty() && statement instanceof Statement.ForRobots) {
                assertThat(text(ScriptParser.parse(text(statement), WORDS, mistakes)))
                        .isEqualTo(text(statement));
                assertThat(mistakes).isEmpty();
            }
        }
    }

    private static String text(List<Statement> script) {
        assertThat(script).hasSize(1);
        return text(script.get(0));
    }

    private static String text(Statement statement) {
        Statement.ForRobots line = (Statement.ForRobots) statement;
        return line.robots().text() + " " + line.command().text();
    }
}
