package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.link.Loopback;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A peer that dies or stalls at each step of connecting, and comes back. */
class ConnectingTest {
    @AutoClose
    private final DrivenAibo driven = DrivenAibo.lying();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aConnectionClosedBeforeTheBannerIsReported(int connection) {
        refusedThenConnected(
                connection, ScriptedDog.Trouble.HANGS_UP, expected(connection, "closed the connection at once"));
    }

    @Test
    void aDogThatDoesNotAnswerMayHaveANewAddress() {
        try (MajicAibo elsewhere = new MajicAibo("aibo://127.0.0.1:" + Loopback.freePort())) {
            assertThatThrownBy(elsewhere::connect)
                    .hasMessageContaining("nothing listens at 127.0.0.1")
                    .hasMessageContaining("another address")
                    .hasMessageContaining("Search the network");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aDogWithoutRoomForAllConnectionsIsBusy(int connection) {
        dog.trouble(connection, ScriptedDog.Trouble.HANGS_UP);

        ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, aibo::connect);

        assertThat(failure.reason()).isEqualTo(ConnectFailed.Reason.BUSY);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aConnectionWithoutABannerIsReported(int connection) {
        refusedThenConnected(
                connection, ScriptedDog.Trouble.SAYS_NOTHING, expected(connection, "not as an URBI server within 4 s"));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void aPartialBannerIsNoBanner(int connection) {
        refusedThenConnected(
                connection, ScriptedDog.Trouble.HALF_A_BANNER, expected(connection, "closed the connection at once"));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void aConnectionClosedAtTheFirstCommandIsReported(int connection) {
        refusedThenConnected(connection, ScriptedDog.Trouble.HANGS_UP_AT_A_COMMAND, "");
    }

    @ParameterizedTest
    @EnumSource(
            value = ScriptedDog.Trouble.class,
            names = {"GARBAGE_FIRST", "SAYS_ALL_IN_SINGLE_BYTES"})
    void noiseAroundTheBannerDoesNotPreventConnecting(ScriptedDog.Trouble trouble) {
        dog.trouble(1, trouble);

        aibo.connect();

        assertThat(aibo.get("battery").number()).isEqualTo(87);
    }

    /** One that has granted a connection is a dog, but one with too little room. */
    private static String expected(int connection, String atFirst) {
        return connection == 0 ? atFirst : "the dog grants only " + connection + " of the three connections";
    }

    private void refusedThenConnected(int connection, ScriptedDog.Trouble trouble, String message) {
        dog.trouble(connection, trouble);
        assertThatThrownBy(aibo::connect).isInstanceOf(BotException.class).hasMessageContaining(message);
        assertThat(aibo.isConnected()).isFalse();

        dog.trouble(connection, ScriptedDog.Trouble.NONE);
        aibo.connect();

        assertThat(aibo.isConnected()).isTrue();
        assertThat(dog.received()).noneMatch(command -> command.contains("robot.stand") || command.contains("motors"));
    }
}
