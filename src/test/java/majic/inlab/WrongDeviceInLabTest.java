package majic.inlab;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.ServiceLoader;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.ScriptedPeer;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Drivers that find another robot, or a server of another kind, at the address of theirs. */
class WrongDeviceInLabTest {
    /** A robot that waits for an intelligible command does not reveal what it is. */
    @ParameterizedTest
    @CsvSource({
        "aibo, pioneer, WRONG_DEVICE",
        "aibo, hemisson, WRONG_DEVICE",
        "pioneer, aibo, WRONG_DEVICE",
        "pioneer, hemisson, NO_ANSWER",
        "hemisson, aibo, WRONG_DEVICE",
        "hemisson, pioneer, NO_ANSWER"
    })
    void anotherRobotIsNotMistakenAndDoesNotMove(String driver, String other, Reason reason) {
        try (LabRig rig = LabRig.exact()) {
            Pose start = rig.truePose(other);
            String there = rig.lab().address(other).orElseThrow().rest();

            assertThat(failure(driver, there, rig.lab().time()).reason()).isEqualTo(reason);

            assertThat(rig.truePose(other)).isEqualTo(start);
        }
    }

    /** The driver of an Aibo sends nothing before the dog has identified itself, so a web server stays silent. */
    @ParameterizedTest
    @CsvSource({"aibo, not as an URBI server", "pioneer, 'says \"HTTP/1.1 400'", "hemisson, 'says \"HTTP/1.1 400'"})
    void aWebServerIsTheWrongDevice(String driver, String message) {
        assertIsWrong(driver, new Stranger("", "HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n"), message);
    }

    @ParameterizedTest
    @ValueSource(strings = {"aibo", "pioneer", "hemisson"})
    void aServerThatIdentifiesItselfIsQuoted(String driver) {
        assertIsWrong(driver, new Stranger("SSH-2.0-OpenSSH_9.2\r\n", ""), "it says \"SSH-2.0-OpenSSH_9.2\"");
    }

    private static void assertIsWrong(String driver, Stranger stranger, String message) {
        try (ScriptedPeer peer = new ScriptedPeer(stranger)) {
            ConnectFailed failure =
                    failure(driver, "//" + peer.address(), peer.clock().time());

            assertThat(failure.reason()).isEqualTo(Reason.WRONG_DEVICE);
            assertThat(failure).hasMessageContaining(message);
        }
    }

    /** Sends a greeting; closes the connection after its answer to the first bytes, if it answers. */
    private static final class Stranger implements ScriptedPeer.Robot {
        private final String greeting;
        private final String answer;
        private boolean answered;

        Stranger(String greeting, String answer) {
            this.greeting = greeting;
            this.answer = answer;
        }

        @Override
        public void connected(ScriptedPeer peer) {
            answered = false;
            send(peer, greeting);
        }

        @Override
        public void received(ScriptedPeer peer, byte[] bytes) {
            send(peer, answer);
            answered = !answer.isEmpty();
        }

        @Override
        public void step(ScriptedPeer peer) {
            if (answered) {
                peer.hangUp();
            }
        }

        private static void send(ScriptedPeer peer, String text) {
            peer.send(text.getBytes(StandardCharsets.US_ASCII));
        }
    }

    private static ConnectFailed failure(String driver, String address, TimeSource time) {
        BotType type = ServiceLoader.load(BotType.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.name().equals(driver))
                .findFirst()
                .orElseThrow();
        try (MajicBot bot =
                type.create(new BotAddress(driver, address), new BotEnvironment(time, Settings.inMemory()))) {
            ConnectFailed failure = catchThrowableOfType(ConnectFailed.class, bot::connect);
            assertThat(bot.connection()).isEqualTo(MajicBot.Connection.LOST);
            return failure;
        }
    }
}
