package majic.shared.message;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.text.OneSentence;

/**
 * Arbitrary messages from a broker: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class MessageFuzzTest {
    private static final Parameter DISTANCE = Parameter.number("distanceFront", Unit.MM, "");

    @FuzzTest
    void aRequestIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("request", payload, Request::parse, Request::toJson);
    }

    @FuzzTest
    void aStateIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("state", payload, RobotState::parse, MessageFuzzTest::shown);
    }

    @FuzzTest
    void aChangeIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("change", payload, StateChange::parse, MessageFuzzTest::shown);
    }

    private static byte[] shown(RobotState state) {
        show(state.values());
        return state.toJson();
    }

    private static byte[] shown(StateChange change) {
        show(change.values());
        return change.toJson();
    }

    /** As values of a number. */
    private static void show(Map<String, JsonNode> values) {
        assertThat(values.values())
                .allSatisfy(json ->
                        assertThat(ValueJson.read(json, DISTANCE).toString()).isNotNull());
    }

    @FuzzTest
    void aDescriptionIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("description", payload, Description::parse, Description::toJson);
    }

    @FuzzTest
    void aScanIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("scan", payload, ScanMessage::parse, ScanMessage::toJson);
    }

    @FuzzTest
    void aStopOfTheTeamIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("stop of the team", payload, LatchMessage::parse, LatchMessage::toJson);
    }

    @FuzzTest
    void anAnswerIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("answer", payload, RequestReply::parse, RequestReply::toJson);
    }

    @FuzzTest
    void aShortMessageIsWrittenAsItWasReadOrRefusedInOneSentence(byte[] payload) {
        assertReadOrRefused("presence", payload, Presence::parse, Presence::toJson);
        assertReadOrRefused("hold", payload, HoldMessage::parse, HoldMessage::toJson);
        assertReadOrRefused("speed", payload, SpeedMessage::parse, SpeedMessage::toJson);
        assertReadOrRefused("stop", payload, StopMessage::parse, StopMessage::toJson);
        assertReadOrRefused("message", payload, RobotMessage::parse, RobotMessage::toJson);
    }

    /** Writing rounds numbers, so what was written once is compared with what was written twice. */
    private static <T> void assertReadOrRefused(
            String name, byte[] payload, Function<byte[], T> parse, Function<T, byte[]> write) {
        T message;
        try {
            message = parse.apply(payload);
        } catch (UnusableMessageException e) {
            assertThat(e).hasMessageStartingWith(name);
            OneSentence.check(e.getMessage());
            return;
        }
        byte[] written = write.apply(message);
        assertThat(new String(write.apply(parse.apply(written)), UTF_8)).isEqualTo(new String(written, UTF_8));
    }
}
