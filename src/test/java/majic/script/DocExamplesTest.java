package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import majic.Page;
import majic.bot.FakeBot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the examples on the page of the language: all of them run, and the behaviour avoids obstacles. */
@Timeout(60)
class DocExamplesTest {
    private static Stream<String> examples() {
        return Page.of("docs/majic-script.md").blocks("majic").map(Page.Code::text);
    }

    static Stream<String> withoutMe() {
        return examples().filter(example -> !hasMe(example));
    }

    private static boolean hasMe(String example) {
        return example.lines().anyMatch(line -> line.strip().startsWith("me "));
    }

    @ParameterizedTest
    @MethodSource("withoutMe")
    void runsWithoutAMistake(String example) throws InterruptedException {
        try (Desk desk = Desk.withTwo()) {
            desk.add(desk.pioneer);
            desk.bot(1).putObstacle(3000);
            for (String line : example.split("\\R")) {
                assertThat(desk.pipe.parseText(line)).as(line).isEmpty();
            }
            desk.pipe.awaitAll();
            assertThat(desk.said()).noneMatch(line -> line.contains("failed")).anyMatch(line -> line.contains("done"));
        }
    }

    @Test
    void theWandererTurnsAwayFromObstaclesUntilItIsStopped(@TempDir Path folder) throws Exception {
        String wanderer = examples().filter(DocExamplesTest::hasMe).findFirst().orElseThrow();
        try (Desk desk = Desk.withTwo()) {
            FakeBot robot = desk.bot(2);
            robot.putObstacle(1000);
            Path file = Files.writeString(folder.resolve("Wander.majic"), wanderer);
            desk.prompt.parseText("2 act \"" + file + "\"");
            desk.pause(10);
            desk.prompt.parseText("2 stop");
            desk.prompt.awaitAll();
            desk.pause(1);
            assertThat(robot.sent()).startsWith("move 2000", "turn 100", "move 2000", "turn 100");
            assertThat(robot.state().pose().xMm()).isLessThanOrEqualTo(540);
            assertThat(desk.said()).contains("2 act \"" + file + "\": stopped");
        }
    }
}
