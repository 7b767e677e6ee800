package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.function.UnaryOperator;
import majic.bot.BotAddress;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.drivertest.ScriptedPeer;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import org.junit.jupiter.api.Test;

/** Ports at which no Hemisson answers, or not all of its answers arrive. */
class NoHemissonThereTest {
    @Test
    void aPortThatEchoesIsRecognised() {
        assertThat(failure(bytes -> bytes))
                .hasMessageContaining("only MAJIC's own questions come back")
                .extracting(ConnectFailed::reason)
                .isEqualTo(Reason.WRONG_DEVICE);
    }

    @Test
    void aTerminalThatEchoesIsRecognised() {
        assertThat(failure(bytes -> latin1(text(bytes).replace("\r", "^M"))))
                .hasMessageContaining("only MAJIC's own questions come back");
        assertThat(failure(bytes -> latin1(text(bytes).replace("\r", "\r\n"))))
                .hasMessageContaining("only MAJIC's own questions come back");
    }

    @Test
    void randomBytesAreNoAnswer() {
        Random random = new Random(5);

        ConnectFailed failure = failure(bytes -> {
            byte[] noise = new byte[40];
            random.nextBytes(noise);
            return noise;
        });

        assertThat(failure).hasMessageContaining("no answer of a Hemisson (in hex: ");
        assertThat(failure.getMessage()).contains("115200 baud").doesNotContain("switch it off");
        assertThat(failure.reason()).isEqualTo(Reason.WRONG_DEVICE);
    }

    @Test
    void answersOfWhichAnotherProgramTakesAPartAreRecognised() {
        ConnectFailed failure = failure(bytes -> latin1(text(bytes).contains("B") ? "OS_v_1." : "own Com"));

        assertThat(failure).hasMessageContaining("another program that has the port open takes the others");
        assertThat(failure.getMessage()).doesNotContain("switch it off");
        assertThat(failure.reason()).isEqualTo(Reason.BUSY);
    }

    @Test
    void answersOfWhichAnotherProgramTakesTheVersionAreRecognised() {
        ConnectFailed failure = failure(bytes -> latin1(text(bytes).contains("B") ? "" : "Unknown Command ?!\r\n"));

        assertThat(failure.reason()).isEqualTo(Reason.BUSY);
    }

    @Test
    void silenceIsCalledSilence() {
        ConnectFailed failure = failure(bytes -> new byte[0]);

        assertThat(failure).hasMessageStartingWith("nothing comes from there; is it the right port");
        assertThat(failure.getMessage()).contains("switch it off, wait 5 s");
        assertThat(failure.reason()).isEqualTo(Reason.NO_ANSWER);
    }

    private static String text(byte[] bytes) {
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }

    private static byte[] latin1(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    private static ConnectFailed failure(UnaryOperator<byte[]> answer) {
        try (ScriptedPeer peer = new ScriptedPeer(new Answering(answer));
                MajicHemisson bot = new MajicHemisson(
                        new BotAddress("hemisson", "//" + peer.address()),
                        new BotEnvironment(peer.clock().time(), Settings.inMemory()))) {
            return catchThrowableOfType(ConnectFailed.class, bot::connect);
        }
    }

    /** Answers everything that comes at once. */
    private record Answering(UnaryOperator<byte[]> answer) implements ScriptedPeer.Robot {
        @Override
        public void received(ScriptedPeer peer, byte[] bytes) {
            byte[] answered = answer.apply(bytes);
            if (answered.length > 0) {
                peer.send(answered);
            }
        }
    }
}
