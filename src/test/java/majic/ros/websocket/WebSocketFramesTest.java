package majic.ros.websocket;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import majic.ros.ServerFrames;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The frames of a server. */
class WebSocketFramesTest {
    private static final int MOST = 1000;
    private static final int FIRST_OF_SEVERAL = 0x01;
    private static final int NEXT = 0x00;
    private static final int LAST = 0x80;

    private static byte[] joined(byte[]... parts) {
        int length = 0;
        for (byte[] part : parts) {
            length += part.length;
        }
        ByteBuffer joined = ByteBuffer.allocate(length);
        for (byte[] part : parts) {
            joined.put(part);
        }
        return joined.array();
    }

    private static List<String> decoded(byte[] wire, int chunk) {
        WebSocketFrames frames = new WebSocketFrames(MOST);
        List<String> messages = new ArrayList<>();
        for (int start = 0; start < wire.length; start += chunk) {
            int count = Math.min(chunk, wire.length - start);
            frames.decode(ByteBuffer.wrap(wire, start, count), message -> messages.add(shown(message)));
        }
        return messages;
    }

    private static String shown(WebSocketMessage message) {
        return message instanceof WebSocketMessage.Ping ping
                ? "ping " + new String(ping.content(), UTF_8)
                : message.toString();
    }

    private static byte[] part(int first, String text) {
        return ServerFrames.frame(first, text.getBytes(UTF_8), text.getBytes(UTF_8).length);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 5000})
    void theSameMessagesComeHoweverTheBytesArrive(int chunk) {
        String longer = "ä".repeat(400);
        byte[] wire = joined(
                ServerFrames.text("one"),
                part(FIRST_OF_SEVERAL, "begun "),
                ServerFrames.frame(ServerFrames.PING, "alive".getBytes(UTF_8)),
                part(NEXT, "continued "),
                part(LAST, "ended"),
                ServerFrames.text(""),
                ServerFrames.text(longer));

        assertThat(decoded(wire, chunk))
                .containsExactly(
                        "Text[text=one]",
                        "ping alive",
                        "Text[text=begun continued ended]",
                        "Text[text=]",
                        "Text[text=" + longer + "]");
    }

    @Test
    void aMessageOverTheLimitIsSkippedAndTheNextOneArrives() {
        byte[] wire = joined(ServerFrames.text("x".repeat(MOST + 1)), ServerFrames.text("next"));

        assertThat(decoded(wire, 100)).containsExactly("TooLong[]", "Text[text=next]");
    }

    @Test
    void theFramesOfAMessageOverTheLimitAreSkippedTogether() {
        byte[] wire = joined(
                part(FIRST_OF_SEVERAL, "x".repeat(MOST)),
                part(NEXT, "y"),
                part(LAST, "z".repeat(MOST)),
                ServerFrames.text("next"));

        assertThat(decoded(wire, 100)).containsExactly("TooLong[]", "Text[text=next]");
    }

    @Test
    void aFrameOfAnyAnnouncedLengthIsNotKept() {
        byte[] wire = ServerFrames.frame(0x82, new byte[5000], Long.MAX_VALUE);

        assertThat(decoded(wire, 5000)).isEmpty();
    }

    @Test
    void aCloseFrameHasItsCodeAndReason() {
        byte[] wire = ServerFrames.frame(
                ServerFrames.CLOSE, joined(new byte[] {0x03, (byte) 0xF1}, "too big".getBytes(UTF_8)));

        assertThat(decoded(wire, 3)).containsExactly("Close[code=1009, reason=too big]");
    }

    @Test
    void whatBreaksTheProtocolEndsTheDecoding() {
        byte[] good = ServerFrames.text("never decoded");

        assertThat(decoded(joined(part(LAST, "no beginning"), good), 100))
                .containsExactly("Violation[what=the continuation of no message]");
        assertThat(decoded(joined(part(FIRST_OF_SEVERAL, "a"), part(0x81, "b"), good), 100))
                .containsExactly("Violation[what=a message inside another one]");
        assertThat(decoded(joined(part(0x83, "reserved"), good), 100))
                .containsExactly("Violation[what=a frame of an unknown kind]");
        assertThat(decoded(joined(part(0xC1, "compressed"), good), 100))
                .containsExactly("Violation[what=a frame of an unknown kind]");
        assertThat(decoded(joined(ServerFrames.frame(0x81, new byte[0], -1), good), 100))
                .containsExactly("Violation[what=a frame of a negative length]");
        assertThat(decoded(joined(part(0x89, "p".repeat(126)), good), 100))
                .containsExactly("Violation[what=a control frame that is too long]");
        assertThat(decoded(joined(new byte[] {(byte) 0x81, (byte) 0x80}, good), 100))
                .containsExactly("Violation[what=a masked frame, which only clients send]");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 125, 126, 65_535, 65_536})
    void whatAClientEncodesAServerDecodes(int length) {
        byte[] content = new byte[length];
        for (int i = 0; i < length; i++) {
            content[i] = (byte) i;
        }
        List<byte[]> received = new ArrayList<>();
        ServerFrames server = new ServerFrames();
        Upgrade upgrade = new Upgrade("host:9090", "/");
        List<byte[]> answers = new ArrayList<>();

        server.receive(upgrade.request(), answers::add, (opcode, bytes) -> received.add(bytes));
        server.receive(
                new FrameEncoder().encode(Opcode.TEXT, content), answers::add, (opcode, bytes) -> received.add(bytes));

        assertThat(received).containsExactly(content);
        assertThat(upgrade.refusal(new String(answers.get(0), UTF_8))).isNull();
    }
}
