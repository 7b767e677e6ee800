package majic.gui.help;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.table.TableModel;
import majic.act.NoActs;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.script.MajicParser;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class HelpTablesTest {
    @Test
    void theCommandsShowEveryTopicOfHelp() {
        TableModel commands = HelpTables.file("commands", "Command", "What it does");
        String examples = String.join("\n", column(commands, 0)) + "\n" + String.join("\n", column(commands, 1));

        List<String> topics = topics();

        assertThat(topics).contains("move", "repeat", "trust");
        assertThat(topics)
                .filteredOn(word -> !List.of("commands", "robots").contains(word))
                .allSatisfy(word -> assertThat(examples).containsPattern("\\b" + word + "\\b"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"commands", "commands_de", "keys", "keys_de", "libraries"})
    void everyRowHasTwoColumns(String name) {
        TableModel table = HelpTables.file(name, "left", "right");

        assertThat(table.getRowCount()).isPositive();
        assertThat(column(table, 0)).doesNotContainNull().noneMatch(String::isBlank);
        assertThat(column(table, 1)).doesNotContainNull().noneMatch(String::isBlank);
    }

    @Test
    void theGermanTablesHaveTheRowsOfTheEnglishOnes() {
        List<String> commands = column(HelpTables.file("commands", "left", "right"), 0);
        TableModel keys = HelpTables.file("keys", "left", "right");

        assertThat(column(HelpTables.file("commands_de", "left", "right"), 0)).isEqualTo(commands);
        assertThat(HelpTables.file("keys_de", "left", "right").getRowCount()).isEqualTo(keys.getRowCount());
    }

    @Test
    void theLibrariesAreThoseOfTheBuild() throws IOException {
        String pom = Files.readString(Path.of("pom.xml"));
        String dependencies = pom.substring(pom.indexOf("</dependencyManagement>"), pom.indexOf("<build>"));
        List<String> used = Pattern.compile("(?s)<dependency>.*?</dependency>")
                .matcher(dependencies)
                .results()
                .map(MatchResult::group)
                .filter(dependency ->
                        !dependency.contains("<scope>test</scope>") && !dependency.contains("<scope>provided</scope>"))
                .map(dependency -> dependency.replaceAll("(?s).*<artifactId>(.*?)</artifactId>.*", "$1"))
                .toList();
        assertThat(used).isNotEmpty();
        assertThat(column(HelpTables.file("libraries", "Library", "Licence"), 0))
                .containsAll(used);
    }

    /** Returns the topics that the command line offers after the word help. */
    private static List<String> topics() {
        BotFactory factory = new BotFactory(List.of(), Settings.inMemory());
        try (Team team = new Team(TimeSource.system())) {
            Session session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
            return MajicParser.prompt(session).complete("help ", 5).words();
        }
    }

    private static List<String> column(TableModel table, int column) {
        return IntStream.range(0, table.getRowCount())
                .mapToObj(row -> (String) table.getValueAt(row, column))
                .toList();
    }
}
