package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The page with the results contains the sizes of the programs as they are. */
class ResultsPageTest {
    private static final Page PAGE = Page.of("docs/results.md");
    private static final Path EXAMPLES = Path.of("examples");

    /** A task and its programs: the robots' own first, then those with MAJIC. */
    private record Task(String name, Program first, List<Program> others) {
        List<String> rows() throws IOException {
            ProgramSize whole = ProgramSize.of(EXAMPLES.resolve(first.file()));
            StringBuilder rows = new StringBuilder("| %s | %s | %d | %d | %d |"
                    .formatted(name, first.link(), whole.lines(), whole.tokens(), whole.words()));
            for (Program other : others) {
                ProgramSize size = ProgramSize.of(EXAMPLES.resolve(other.file()));
                rows.append("\n| | %s | %s | %s | %s |"
                        .formatted(
                                other.link(),
                                share(size.lines(), whole.lines()),
                                share(size.tokens(), whole.tokens()),
                                share(size.words(), whole.words())));
            }
            return rows.toString().lines().toList();
        }

        private static String share(int part, int whole) {
            return "%d (%d %%)".formatted(part, Math.round(100.0 * part / whole));
        }
    }

    private record Program(String language, String file) {
        String link() {
            return "[" + language + "](../examples/" + file + ")";
        }
    }

    private static final List<Task> TASKS = List.of(
            new Task(
                    "race of a team",
                    new Program("C++ with ARIA", "native/GreatRace.cpp"),
                    List.of(
                            new Program("Java with MAJIC", "MajicRace.java"),
                            new Program("MAJIC Script", "race.majic"))),
            new Task(
                    "Pioneer wanders",
                    new Program("C++ with ARIA", "native/Wanderer.cpp"),
                    List.of(
                            new Program("Java with MAJIC", "Wanderer.java"),
                            new Program("MAJIC Script", "wander.majic"))),
            new Task(
                    "Pioneer wanders by what is supplied",
                    new Program("C++ with ARIA", "native/Actions.cpp"),
                    List.of(new Program("MAJIC Script", "act.majic"))),
            new Task(
                    "Hemisson follows a line",
                    new Program("C++ with its serial lines", "native/LineFollower.cpp"),
                    List.of(
                            new Program("Java with MAJIC", "LineFollower.java"),
                            new Program("MAJIC Script", "line.majic"))),
            new Task(
                    "Aibo wanders",
                    new Program("URBI", "native/WanderDog.u"),
                    List.of(
                            new Program("Java with MAJIC", "WanderDog.java"),
                            new Program("MAJIC Script", "wander_dog.majic"))),
            new Task(
                    "patrol of a team",
                    new Program("C++ with ARIA", "native/ToAndFro.cpp"),
                    List.of(new Program("MAJIC Script", "to_and_fro.majic"))),
            new Task(
                    "Pioneer follows a wall",
                    new Program("C++ with ARIA", "native/Wall.cpp"),
                    List.of(new Program("MAJIC Script", "wall.majic"))),
            new Task(
                    "Pioneer searches in a spiral",
                    new Program("C++ with ARIA", "native/Spiral.cpp"),
                    List.of(new Program("MAJIC Script", "spiral.majic"))),
            new Task(
                    "Aibo walks half a metre",
                    new Program("URBI", "native/Walk.u"),
                    List.of(new Program("MAJIC Script", "walk.majic"))));

    @Test
    void thePageHasTheSizeOfEachProgram() throws IOException {
        StringBuilder rows = new StringBuilder();
        for (Task task : TASKS) {
            task.rows().forEach(row -> rows.append(row).append('\n'));
        }
        assertThat(PAGE.text()).contains(rows);
    }

    @Test
    void aProgramOfSeveralRobotsOrOfAPioneerIsAThirdAsLongWithMajic() throws IOException {
        assertThat(lines("MajicRace.java")).isLessThanOrEqualTo(lines("native/GreatRace.cpp") / 3);
        assertThat(lines("Wanderer.java")).isLessThanOrEqualTo(lines("native/Wanderer.cpp") / 3);
    }

    @Test
    void aScriptHasAThirdOfTheLinesAndForTheAiboNotMore() throws IOException {
        assertThat(lines("to_and_fro.majic")).isLessThanOrEqualTo(lines("native/ToAndFro.cpp") / 3);
        assertThat(lines("wall.majic")).isLessThanOrEqualTo(lines("native/Wall.cpp") / 3);
        assertThat(lines("spiral.majic")).isLessThanOrEqualTo(lines("native/Spiral.cpp") / 3);
        assertThat(lines("wander_dog.majic")).isLessThanOrEqualTo(lines("native/WanderDog.u"));
    }

    private static int lines(String file) throws IOException {
        return ProgramSize.of(EXAMPLES.resolve(file)).lines();
    }
}
