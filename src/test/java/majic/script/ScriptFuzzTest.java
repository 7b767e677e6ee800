package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.text.OneSentence;

/**
 * Arbitrary lines, scripts and saved teams: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ScriptFuzzTest {
    /** What would read or write files of any name. */
    private static final Pattern FILES = Pattern.compile("(?iu)save|run|act|trust|log");

    private static final Pattern MOTION = Pattern.compile("(?m)^(move|turn|drive|headPan) ");

    private static final int MOST_LINES = 30;

    @FuzzTest
    void everyLineIsTakenOrRefusedInOneSentenceAndStopEndsIt(byte[] bytes) throws InterruptedException {
        String tamed = FILES.matcher(text(bytes)).replaceAll("get");
        try (ScriptFixture fixture = ScriptFixture.withTwo()) {
            tamed.lines().limit(MOST_LINES).forEach(line -> {
                fixture.prompt.parseText(line).ifPresent(OneSentence::check);
                fixture.prompt.complete(line, line.length() / 2);
            });
            fixture.prompt.parseText("stop");
            fixture.prompt.awaitAll();

            assertThat(fixture.prompt.isBlockOpen()).isFalse();
            assertThat(fixture.team.members()).allMatch(member -> isHalted((FakeBot) member.bot()));
        }
    }

    private static boolean isHalted(FakeBot bot) {
        List<String> sent = bot.sent();
        return MOTION.matcher(String.join("\n", sent.subList(sent.lastIndexOf("halt") + 1, sent.size())))
                .results()
                .findAny()
                .isEmpty();
    }

    @FuzzTest
    void everyScriptIsABehaviourOrRefusedWithItsPlaces(byte[] bytes) {
        String text = text(bytes);
        try {
            ScriptAct act = new ScriptAct("odd.majic", text);
            assertThat(act.roles()).isNotEmpty();
            assertThat(act.arguments()).doesNotContainNull();
            assertThat(new ScriptAct("odd.majic", text + "\n#").roles()).isEqualTo(act.roles());
        } catch (BotException e) {
            assertThat(e).hasMessageStartingWith("odd.majic");
            OneSentence.check(e.getMessage());
        }
    }

    @FuzzTest
    void everyTeamIsReadOrRefusedWithItsLine(byte[] bytes) {
        try (ScriptFixture fixture = new ScriptFixture()) {
            SavedTeam team = SavedTeam.parse(text(bytes));
            assertThat(team.names(fixture.factory)).doesNotContainNull();
            assertThat(team.names(fixture.factory).isEmpty()).isEqualTo(team.isEmpty());
        } catch (BotException e) {
            assertThat(e.getMessage()).matches("line \\d+: .*");
            OneSentence.check(e.getMessage());
        }
    }

    private static String text(byte[] bytes) {
        return new String(bytes, StandardCharsets.UTF_8);
    }
}
