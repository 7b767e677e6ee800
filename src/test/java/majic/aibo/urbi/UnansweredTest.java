package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UnansweredTest {
    private static final UrbiMessage.Failure SYNTAX = new UrbiMessage.Failure("19.14: syntax error, unexpected <");

    private final Unanswered unanswered = new Unanswered();
    private final Ask walk = new Ask("walk1", Ask.Expects.END);
    private final Ask reading = new Ask("r1", Ask.Expects.VALUE);
    private final Ask ping = new Ask("p1", Ask.Expects.PONG);

    @BeforeEach
    void ask() {
        unanswered.add(walk);
        unanswered.add(reading);
        unanswered.add(ping);
    }

    @Test
    void aTagNamesItsCommand() {
        hear("r1", new UrbiMessage.Result(new UrbiValue.Num(3)), Dialect.V1_0);

        assertThat(reading.value()).isEqualTo(new UrbiValue.Num(3));
        assertThat(walk.isDone()).isFalse();
    }

    @Test
    void aSyntaxErrorAnswersTheOldestCommandAndTheNextTheOneBehindIt() {
        hear("error", SYNTAX, Dialect.V1_0);
        hear("error", new UrbiMessage.Info("20.3-4: syntax error"), Dialect.V1_0);

        assertThat(walk.failure()).startsWith("19.14");
        assertThat(reading.failure()).startsWith("20.3-4");
        assertThat(ping.isDone()).isFalse();
    }

    @Test
    void theTwoLinesAboutACommandThatThereWasNoRoomForAnswerOne() {
        hear("error", new UrbiMessage.Failure("Receive buffer full"), Dialect.V1_0);
        hear("error", new UrbiMessage.Failure("Receive buffer corrupted"), Dialect.V1_0);

        assertThat(walk.failure()).isEqualTo("Receive buffer full");
        assertThat(reading.isDone() || ping.isDone()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"CPU Overload", "Out of memory", "Memory overflow warning", "Send buffer full", "21 is no place"
            })
    void theServersOwnTroublesAnswerNobody(String trouble) {
        hear("error", new UrbiMessage.Failure(trouble), Dialect.V1_0);
        hear("warning", new UrbiMessage.Failure(trouble), Dialect.V1_0);
        hear("power", new UrbiMessage.Info("Battery at 87 %"), Dialect.V1_0);

        assertThat(walk.isDone() || reading.isDone() || ping.isDone()).isFalse();
    }

    @Test
    void aPongWithoutTagAnswersThePing() {
        hear("notag", new UrbiMessage.Info("pong time=5918"), Dialect.V1_5);

        assertThat(ping.isDone()).isTrue();
        assertThat(walk.isDone()).isFalse();
    }

    @Test
    void anErrorWithoutTagAnswersTheOldestCommandOnlyWhereTagsAreLeftOut() {
        UrbiMessage.Failure unknown = new UrbiMessage.Failure("Unknown identifier: robot");

        hear("notag", unknown, Dialect.V1_0);
        assertThat(walk.isDone()).isFalse();

        hear("notag", unknown, Dialect.V1_5);
        assertThat(walk.failure()).isEqualTo("Unknown identifier: robot");
    }

    private void hear(String tag, UrbiMessage.Body body, Dialect dialect) {
        unanswered.answer(new UrbiMessage(5000, tag, body), dialect);
    }
}
