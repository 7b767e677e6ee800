package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.mockito.Mockito;

class LinkTransportTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    private final LinkTransport.Decoding decoding =
            new LinkTransport.Decoding("sensors", Mockito.mock(UrbiTransport.Receiver.class), clock.time());

    @Test
    void losesPatienceWithACutBinaryAfterASecond() throws InterruptedException {
        assertThat(read("[00000001:cam] BIN 1000000 jpeg 208 160\nxxx")).isEmpty();
        assertThat(read("[00000002:b] 2.000000\n")).isEmpty();
        clock.time().sleep(1.1);

        assertThat(read("[00000003:c] 3.000000\n")).extracting(UrbiMessage::tag).containsExactly("b", "c");
    }

    @Test
    void anImageThatTakesThreeSecondsToArriveIsWhole() throws InterruptedException {
        String quarter = "[0]".repeat(20_000);
        assertThat(read("[00000001:cam] BIN 240000 YCbCr 208 160\n")).isEmpty();
        for (int part = 0; part < 3; part++) {
            assertThat(read(quarter)).isEmpty();
            clock.time().sleep(1.1);
        }

        assertThat(read(quarter + "[00000002:b] 2.000000\n"))
                .extracting(UrbiMessage::tag)
                .containsExactly("cam", "b");
    }

    @Test
    void anImageOfAMegabyteCutInHalfCostsOnlyItself() throws InterruptedException {
        assertThat(read("[00000001:cam] BIN 1000000 jpeg 208 160\n" + "\u00ff".repeat(500_000)))
                .isEmpty();
        assertThat(read("[00000002:b] 2.000000\n[00000003:cam] BIN 5 jpeg 208 160\nhello"))
                .isEmpty();
        clock.time().sleep(1.1);

        assertThat(read("[00000004:c] 3.000000\n")).extracting(UrbiMessage::tag).containsExactly("b", "cam", "c");
    }

    private List<UrbiMessage> read(String wire) {
        byte[] bytes = wire.getBytes(StandardCharsets.ISO_8859_1);
        List<UrbiMessage> messages = new ArrayList<>();
        decoding.decode(bytes, bytes.length, messages::add);
        return messages;
    }
}
