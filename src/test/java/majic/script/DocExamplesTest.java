package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import majic.bot.FakeBot;
import majic.docs.Page;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the examples on the page of the language: all of them run, and the behaviour avoids obstacles. */
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
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            fixture.add(fixture.pioneer);
            fixture.bot(1).putObstacle(3000);
            for (String line : example.split("\\R")) {
                assertThat(fixture.pipe.parseText(line)).as(line).isEmpty();
            }
            fixture.pipe.awaitAll();
            assertThat(fixture.answers())
                    .noneMatch(line -> line.contains("failed"))
                    .anyMatch(line -> line.contains("done"));
        }
    }

    @Test
    void theWandererTurnsAwayFromObstaclesUntilItIsStopped(@TempDir Path folder) throws Exception {
        String wanderer = examples().filter(DocExamplesTest::hasMe).findFirst().orElseThrow();
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            FakeBot robot = fixture.bot(2);
            robot.putObstacle(1000);
            Path file = Files.writeString(folder.resolve("Wander.majic"), wanderer);
            fixture.prompt.parseText("2 act \"" + file + "\"");
            fixture.pause(10);
            fixture.prompt.parseText("2 stop");
            fixture.prompt.awaitAll();
            fixture.pause(1);
            assertThat(robot.sent()).startsWith("move 2000", "turn 100", "move 2000", "turn 100");
            assertThat(robot.state().pose().xMm()).isLessThanOrEqualTo(540);
            assertThat(fixture.answers()).contains("2 act \"" + file + "\": stopped");
        }
    }
}
