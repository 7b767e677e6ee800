package majic.ros.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;

/**
 * Arbitrary messages from a rosbridge server: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class OperationsFuzzTest {
    private final List<String> notices = new ArrayList<>();
    private final Goals goals = new Goals();
    private final PendingCalls calls = new PendingCalls();

    /** Passes answers to one call and one goal. */
    private final class Receivers implements OperationRouter.Routes {
        @Override
        public void published(String topic, JsonNode message, int bytes) {
            assertThat(topic).isNotNull();
        }

        @Override
        public void answered(ObjectNode response) {
            calls.answered(response);
        }

        @Override
        public void feedback(ObjectNode feedback) {
            goals.feedback(feedback);
        }

        @Override
        public void result(ObjectNode result) {
            goals.result(result);
        }

        @Override
        public void leftOut() {}

        @Override
        public void notice(String message) {
            notices.add(message);
        }

        @Override
        public void ended(IOException cause) {
            throw new AssertionError("no message ends the connection", cause);
        }
    }

    /** A goal whose events are not looked at. */
    private static final class Ignored implements ActionGoal.Events {
        @Override
        public void feedback(JsonNode values) {}

        @Override
        public void result(int status, JsonNode values) {}

        @Override
        public void failed(BotException cause) {}
    }

    @FuzzTest
    void anyMessageIsRoutedOrIgnoredWithoutAnError(byte[] bytes) {
        notices.clear(); // a search runs all inputs on one object
        calls.add(new ServiceCall("/service", () -> {}));
        goals.add(new Ignored());
        OperationRouter router = new OperationRouter(new Receivers());
        String text = new String(bytes, StandardCharsets.UTF_8);

        router.binary(bytes);
        router.text(text);
        for (String line : text.split("\n")) {
            router.text(line);
        }

        assertThat(notices).doesNotHaveDuplicates();
    }

    @FuzzTest
    void fragmentsAreJoinedOrForgotten(byte[] bytes) {
        Fragments fragments = new Fragments(bytes.length);
        for (int i = 0; i + 3 < bytes.length; i += 4) {
            ObjectNode fragment = JsonNodeFactory.instance.objectNode();
            fragment.put("id", bytes[i] & 3).put("num", bytes[i + 1]).put("total", bytes[i + 2] / 3.0);
            fragment.put("data", "x".repeat(bytes[i + 3] & 0x7F));
            String whole = fragments.add(fragment);
            assertThat(whole == null ? 0 : whole.length()).isLessThanOrEqualTo(bytes.length);
        }
    }
}
