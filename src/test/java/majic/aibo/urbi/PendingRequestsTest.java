package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PendingRequestsTest {
    private static final UrbiMessage.Failure SYNTAX = new UrbiMessage.Failure("19.14: syntax error, unexpected <");

    private final PendingRequests pending = new PendingRequests();
    private final UrbiRequest walk = new UrbiRequest("walk1", UrbiRequest.Expects.END);
    private final UrbiRequest reading = new UrbiRequest("r1", UrbiRequest.Expects.VALUE);
    private final UrbiRequest ping = new UrbiRequest("p1", UrbiRequest.Expects.PONG);

    @BeforeEach
    void ask() {
        pending.add(walk);
        pending.add(reading);
        pending.add(ping);
    }

    @Test
    void aTagNamesItsCommand() {
        hear("r1", new UrbiMessage.Result(new UrbiValue.Num(3)), UrbiVersion.V1_0);

        assertThat(reading.value()).isEqualTo(new UrbiValue.Num(3));
        assertThat(walk.isDone()).isFalse();
    }

    @Test
    void aSyntaxErrorAnswersTheOldestCommandAndTheNextTheOneBehindIt() {
        hear("error", SYNTAX, UrbiVersion.V1_0);
        hear("error", new UrbiMessage.Info("20.3-4: syntax error"), UrbiVersion.V1_0);

        assertThat(walk.failure()).startsWith("19.14");
        assertThat(reading.failure()).startsWith("20.3-4");
        assertThat(ping.isDone()).isFalse();
    }

    @Test
    void theTwoLinesAboutACommandThatThereWasNoRoomForAnswerOne() {
        hear("error", new UrbiMessage.Failure("Receive buffer full"), UrbiVersion.V1_0);
        hear("error", new UrbiMessage.Failure("Receive buffer corrupted"), UrbiVersion.V1_0);

        assertThat(walk.failure()).isEqualTo("Receive buffer full");
        assertThat(reading.isDone() || ping.isDone()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"CPU Overload", "Out of memory", "Memory overflow warning", "Send buffer full", "21 is no place"
            })
    void theServersOwnTroublesAnswerNoRequest(String trouble) {
        hear("error", new UrbiMessage.Failure(trouble), UrbiVersion.V1_0);
        hear("warning", new UrbiMessage.Failure(trouble), UrbiVersion.V1_0);
        hear("power", new UrbiMessage.Info("Battery at 87 %"), UrbiVersion.V1_0);

        assertThat(walk.isDone() || reading.isDone() || ping.isDone()).isFalse();
    }

    @Test
    void aPongWithoutTagAnswersThePing() {
        hear("notag", new UrbiMessage.Info("pong time=5918"), UrbiVersion.V1_5);

        assertThat(ping.isDone()).isTrue();
        assertThat(walk.isDone()).isFalse();
    }

    @Test
    void anErrorWithoutTagAnswersTheOldestCommandOnlyWhereTagsAreLeftOut() {
        UrbiMessage.Failure unknown = new UrbiMessage.Failure("Unknown identifier: robot");

        hear("notag", unknown, UrbiVersion.V1_0);
        assertThat(walk.isDone()).isFalse();

        hear("notag", unknown, UrbiVersion.V1_5);
        assertThat(walk.failure()).isEqualTo("Unknown identifier: robot");
    }

    private void hear(String tag, UrbiMessage.Body body, UrbiVersion version) {
        pending.answer(new UrbiMessage(5000, tag, body), version);
    }
}
