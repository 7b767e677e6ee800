package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import majic.pioneer.arcos.Packet;
import org.junit.jupiter.api.Test;

/** Other devices than a Pioneer at its address. */
class ForeignPeerTest {
    private static final byte[] RFC_2217 = {(byte) 0xFF, (byte) 0xFB, 0x2C};

    @Test
    void aServerWithAGreetingIsQuoted() {
        try (PioneerRig stage = facing(text("SSH-2.0-OpenSSH_9.2\r\n"))) {
            assertThatThrownBy(stage.bot::connect)
                    .hasMessageContaining(
                            "not as a Pioneer does; it says \"SSH-2.0-OpenSSH_9.2\"; is it the right port?");
        }
    }

    @Test
    void unreadableBytesLeadToTheQuestionAboutTheSpeed() {
        try (PioneerRig stage = facing(new byte[] {0x1C, (byte) 0xE0, 0x7F})) {
            assertThatThrownBy(stage.bot::connect)
                    .hasMessageEndingWith("is it the right port, and its speed the robot's?");
        }
    }

    @Test
    void aTelnetServerIsRefusedAtOnce() {
        try (PioneerRig stage = facing(RFC_2217)) {
            double seconds = stage.secondsOf(
                    () -> assertThatThrownBy(stage.bot::connect).hasMessageContaining("telnet (RFC 2217)"));
            assertThat(seconds).isLessThan(1);
        }
    }

    @Test
    void aLineThatSendsBackWhatItReceivesIsNoRobot() {
        SteppedPeer.Robot echo = (line, packet) -> line.send(packet.bytes());
        try (PioneerRig stage = new PioneerRig(ScriptedPioneer.robot(), echo, 0)) {
            assertThatThrownBy(stage.bot::connect).hasMessageContaining("sends back what it receives");
        }
    }

    private static PioneerRig facing(byte[] greeting) {
        return new PioneerRig(ScriptedPioneer.robot(), new Greeter(greeting), 0);
    }

    private static byte[] text(String greeting) {
        return greeting.getBytes(StandardCharsets.US_ASCII);
    }

    /** Sends one message to every client. */
    private record Greeter(byte[] greeting) implements SteppedPeer.Robot {
        @Override
        public void connected(SteppedPeer line) {
            line.send(greeting);
        }

        @Override
        public void received(SteppedPeer line, Packet packet) {}
    }
}
