package majicsim.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.packet.Hex;
import org.junit.jupiter.api.Test;

class HandshakeTest {
    private static final byte[] SYNC0 = Hex.bytes("FA FB 03 00 00 00");
    private static final byte[] SYNC1 = Hex.bytes("FA FB 03 01 00 01");
    private static final byte[] LOST_STEP = Hex.bytes("FA FB 03 FF 00 FF");

    private final Handshake handshake = new Handshake("Mock_1", PioneerModel.of("p3dx-sh"));

    @Test
    void syncsAreEchoedAndTheLastOneIsAnsweredWithTheNames() {
        assertThat(handshake.answer(0)).isEqualTo(SYNC0);
        assertThat(handshake.answer(1)).isEqualTo(SYNC1);
        assertThat(handshake.isComplete()).isFalse();
        assertThat(new String(handshake.answer(2), StandardCharsets.ISO_8859_1)).contains("Mock_1\0Pioneer\0p3dx-sh\0");
        assertThat(handshake.isComplete()).isTrue();
    }

    @Test
    void aSyncOutOfOrderMakesTheClientStartOver() {
        handshake.answer(0);
        assertThat(handshake.answer(2)).isEqualTo(LOST_STEP);
        assertThat(handshake.answer(1)).isEqualTo(LOST_STEP);
        assertThat(handshake.answer(0)).isEqualTo(SYNC0);
        assertThat(handshake.answer(1)).isEqualTo(SYNC1);
    }

    @Test
    void sync0IsAlwaysWelcome() {
        handshake.answer(0);
        handshake.answer(1);
        assertThat(handshake.answer(0)).isEqualTo(SYNC0);
        assertThat(handshake.answer(1)).isEqualTo(SYNC1);
    }

    @Test
    void aCommandBeforeTheHandshakeIsOutOfStep() {
        assertThat(handshake.answer(11)).isEqualTo(LOST_STEP);
        assertThat(handshake.isComplete()).isFalse();
    }

    @Test
    void onceCompleteItAnswersNothing() {
        handshake.answer(0);
        handshake.answer(1);
        handshake.answer(2);
        assertThat(handshake.answer(0)).isNull();
    }
}
