package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.script.help.Completion;
import majic.script.help.Completions;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is offered where a line names a file. */
class FileCompletionTest {
    @TempDir
    private static Path folder;

    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @BeforeEach
    void writeFiles() throws IOException {
        Files.createDirectories(folder.resolve("square dances/old"));
        for (String name :
                List.of("square.majic", "Square two.majic", "notes.txt", "Wave.act", ".hidden", "a#b.majic")) {
            Files.writeString(folder.resolve(name), "");
        }
        Files.writeString(folder.resolve("square dances/slow.majic"), "");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "run FOLDER/sq | \"FOLDER/square dances/ : \"FOLDER/Square two.majic\" : FOLDER/square.majic",
                "run \"FOLDER/sq | \"FOLDER/square dances/ : \"FOLDER/Square two.majic\" : \"FOLDER/square.majic\"",
                "run FOLDER/no | FOLDER/notes.txt",
                "run \"FOLDER/square dances/ | \"FOLDER/square dances/old/ : \"FOLDER/square dances/slow.majic\"",
                "run FOLDER/a | \"FOLDER/a#b.majic\"",
                "run FOLDER/. | FOLDER/.hidden",
                "save log FOLDER/no | FOLDER/notes.txt",
                "save session FOLDER/square. | FOLDER/square.majic",
                "trust FOLDER/ | \"FOLDER/a#b.majic\" : \"FOLDER/square dances/ : \"FOLDER/Square two.majic\""
                        + " : FOLDER/square.majic : FOLDER/Wave.act",
                "1 act FOLDER/w | FOLDER/Wave.act",
                "1,2 act FOLDER/w | FOLDER/Wave.act"
            })
    void theFilesThatBeginSoAreOfferedWithQuotesWhereTheyAreNeeded(String typed, String expected) {
        List<String> paths = List.of(here(expected).split(" : "));

        assertThat(complete(typed).words()).containsExactlyInAnyOrderElementsOf(paths);
    }

    @Test
    void theWholePathIsReplacedAndAFolderIsMarked() {
        Completions found = complete("run FOLDER/square");

        assertThat(found.start()).isEqualTo(4);
        assertThat(found.entries()).contains(new Completion(here("\"FOLDER/square dances/"), "", "a folder"));
    }

    @Test
    void aNameInQuotesIsThatOfTheFile() throws Exception {
        Files.writeString(folder.resolve("Square two.majic"), "1 move 70");

        fixture.runPipe("run " + complete("run \"FOLDER/square t").words().get(0));

        assertThat(fixture.bot(1).sent()).contains("move 70");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "run",
                "run FOLDER/notes.txt ",
                "run \"FOLDER/notes.txt\"",
                "run FOLDER/nowhere/",
                "run FOLDER/zebra",
                "save FOLDER/no",
                "1 move FOLDER/no"
            })
    void noFileIsOfferedElsewhere(String typed) {
        assertThat(complete(typed).words()).noneMatch(word -> word.contains("/"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"run x", "save team x", "trust x", "1 act x"})
    void completingAFileIsKnownToReadFiles(String typed) {
        assertThat(MajicParser.readsFiles(typed)).isTrue();
    }

    private Completions complete(String typed) {
        String line = here(typed);
        return fixture.prompt.complete(line, line.length());
    }

    private static String here(String text) {
        return text.replace("FOLDER", folder.toString().replace('\\', '/'));
    }
}
