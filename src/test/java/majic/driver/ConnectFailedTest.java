package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.junit.jupiter.params.provider.Arguments.of;

import java.io.IOException;
import java.net.ConnectException;
import java.net.NoRouteToHostException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import majic.aibo.MajicAibo;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.MajicBot;
import majic.hemisson.MajicHemisson;
import majic.pioneer.MajicPioneer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that failures to connect are told apart. */
class ConnectFailedTest {
    /** A port of this computer at which nothing listens. */
    private static final String NOBODY = "127.0.0.1:1";

    static Stream<Arguments> causes() {
        return Stream.of(
                of(new UnknownHostException("h"), Reason.UNKNOWN_HOST),
                of(new ConnectException("refused"), Reason.REFUSED),
                of(new SocketTimeoutException("late"), Reason.NO_ANSWER),
                of(new NoRouteToHostException("far"), Reason.NO_ANSWER),
                of(new TimeoutException("late"), Reason.NO_ANSWER),
                of(new NoSuchFileException("COM9"), Reason.NO_SUCH_PORT),
                of(new AccessDeniedException("COM9"), Reason.NOT_ALLOWED),
                of(new FileSystemException("COM9"), Reason.BUSY),
                of(new IllegalStateException("odd"), Reason.OTHER));
    }

    @ParameterizedTest
    @MethodSource("causes")
    void theReasonFollowsFromTheCause(Exception cause, Reason reason) {
        ConnectFailed failure = ConnectFailed.of(new IOException("no connection", cause));

        assertThat(failure.reason()).isEqualTo(reason);
        assertThat(failure).hasMessage("no connection").hasRootCause(cause);
    }

    @Test
    void aPioneerThatNothingListensForIsRefused() {
        assertThat(reasonOf(new MajicPioneer("pioneer://" + NOBODY))).isEqualTo(Reason.REFUSED);
    }

    @Test
    void anAiboThatNothingListensForIsRefused() {
        assertThat(reasonOf(new MajicAibo("aibo://" + NOBODY))).isEqualTo(Reason.REFUSED);
    }

    @Test
    void aHemissonThatNothingListensForIsRefused() {
        assertThat(reasonOf(new MajicHemisson("hemisson://" + NOBODY))).isEqualTo(Reason.REFUSED);
    }

    @Test
    void aSerialPortThatIsNotThereIsMissing() {
        assertThat(reasonOf(new MajicHemisson("hemisson:noSuchPort"))).isEqualTo(Reason.NO_SUCH_PORT);
    }

    private static Reason reasonOf(MajicBot robot) {
        try (robot) {
            ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, robot::connect);
            assertThat(robot.connection()).isEqualTo(MajicBot.Connection.LOST);
            return failure.reason();
        }
    }
}
