package majic.ros.websocket;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Arbitrary bytes from a server: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ServerBytesFuzzTest {
    private static final int MOST = 4096;

    private static List<String> decoded(byte[] wire, int chunk) {
        ServerBytes decoder = new ServerBytes(MOST);
        List<String> messages = new ArrayList<>();
        Consumer<WebSocketMessage> add = message -> messages.add(shown(message));
        for (int start = 0; start < wire.length; start += chunk) {
            byte[] part = Arrays.copyOfRange(wire, start, Math.min(wire.length, start + chunk));
            decoder.decode(part, part.length, add);
        }
        return messages;
    }

    private static String shown(WebSocketMessage message) {
        if (message instanceof WebSocketMessage.Binary binary) {
            return "binary " + Arrays.toString(binary.bytes());
        }
        if (message instanceof WebSocketMessage.Pong pong) {
            return "pong " + Arrays.toString(pong.content());
        }
        return message instanceof WebSocketMessage.Ping ping
                ? "ping " + Arrays.toString(ping.content())
                : message.toString();
    }

    @FuzzTest
    void theSameMessagesComeHoweverTheBytesAreCut(byte[] wire) {
        int chunk = wire.length == 0 ? 1 : 1 + (wire[wire.length - 1] & 0x3F);

        assertThat(decoded(wire, chunk)).isEqualTo(decoded(wire, wire.length + 1));
    }

    @FuzzTest
    void anyAnswerIsAcceptedOrRefusedWithItsFirstLine(byte[] wire) {
        Upgrade upgrade = new Upgrade("robot:9090", "/");
        ServerBytes decoder = new ServerBytes(MOST);
        decoder.decode(wire, wire.length, message -> {
            if (message instanceof WebSocketMessage.Answer answer) {
                assertThat(upgrade.refusal(answer.head())).isNotNull().doesNotContain("\n");
            }
        });
    }
}
