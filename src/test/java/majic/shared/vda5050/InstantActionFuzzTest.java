package majic.shared.vda5050;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import majic.bot.BotException;
import majic.text.OneSentence;

/**
 * Arbitrary messages from fleet tools: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class InstantActionFuzzTest {
    @FuzzTest
    void actionsAreReadOrRefusedInOneSentence(byte[] payload) {
        try {
            assertThat(InstantAction.parse(payload)).allSatisfy(action -> {
                OneSentence.check(action.id());
                OneSentence.check(action.type());
            });
        } catch (BotException e) {
            OneSentence.check(e.getMessage());
        }
    }
}
