package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.List;
import java.util.Random;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Clients like those of other projects come one after the other to the same port, and half of them go without CLOSE.
 */
@Timeout(value = 180, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class AgainAndAgainTest {
    private static final int SESSIONS = 40;
    private static final List<Kind> NETWORK = List.of(
            link -> new AriaClient(link, false),
            link -> new P2osClient(link, false, false),
            link -> new P2osClient(link, false, true));
    private static final List<Kind> SERIAL = List.of(
            link -> new AriaClient(link, true),
            link -> new P2osClient(link, true, false),
            link -> new P2osClient(link, true, true));

    private final Random random = new Random(4);

    @AutoClose
    private Stand stand;

    @BeforeEach
    void open() throws IOException {
        stand = new Stand(Noise.exact());
    }

    @Test
    void overTheNetwork() throws IOException {
        for (int i = 0; i < SESSIONS; i++) {
            session(any(NETWORK).on(stand.tcpClient()));
        }
        assertThat(stand.tcpClient().during(0.3)).isEmpty();
    }

    @Test
    void overTheSerialLine() throws IOException {
        assumeTrue(stand.hasSerialPort(), "no pseudo-terminals here");
        for (int i = 0; i < SESSIONS; i++) {
            session(any(SERIAL).on(stand.serialClient()));
        }
    }

    @Test
    void nowOverTheOneAndThenOverTheOther() throws IOException {
        assumeTrue(stand.hasSerialPort(), "no pseudo-terminals here");
        for (int i = 0; i < 10; i++) {
            session(any(SERIAL).on(stand.serialClient()));
            stand.step(2);
            session(any(NETWORK).on(stand.tcpClient()));
        }
    }

    @Test
    void overANoisySerialLineThatTakesItsTime() throws IOException {
        try (Stand noisy = new Stand(Noise.seeded(9))) {
            assumeTrue(noisy.hasSerialPort(), "no pseudo-terminals here");
            for (Kind kind : SERIAL) {
                VendorClient client = kind.on(noisy.serialClient());
                client.connect();
                client.driveAndRead();
                client.disconnect();
            }
        }
    }

    private Kind any(List<Kind> kinds) {
        return kinds.get(random.nextInt(kinds.size()));
    }

    private void session(VendorClient client) throws IOException {
        stand.rig.body().place(new Pose(0, 0, 0));
        client.connect();
        client.driveAndRead();
        if (random.nextBoolean()) {
            client.disconnect();
        } else {
            client.vanish();
        }
    }

    private interface Kind {
        VendorClient on(StandClient link);
    }
}
