package majic.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import majic.script.MajicParser;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AdmissionTest {
    private static final String WORD = "0123456789abcdef0123";

    @AutoClose
    private final RobotTeam robots = new RobotTeam();

    private final AtomicLong nanos = new AtomicLong();
    private final Admission admission = new Admission(ListenToken.chosen(WORD), nanos::get);
    private final MajicParser parser = MajicParser.socket(robots.session);
    private final InetAddress near = InetAddress.getLoopbackAddress();
    private final InetAddress far = InetAddress.getByName("192.0.2.7");
    private final InetAddress other = InetAddress.getByName("192.0.2.8");

    AdmissionTest() throws UnknownHostException {}

    @ParameterizedTest
    @ValueSource(strings = {WORD, WORD + " all", "  " + WORD + "  ALL "})
    void theTokenIsAdmitted(String line) {
        assertThat(admission.refusal(line, far, parser)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "all", WORD + "4", "1 stop", WORD + " bots"})
    void anotherLineIsRefused(String line) {
        assertThat(admission.refusal(line, far, parser)).contains("the first line must be the token of this MAJIC");
    }

    @Test
    void afterTenWrongTokensAnAddressWaitsWhileOthersDoNot() {
        for (int attempt = 0; attempt < Admission.WRONG_TOKENS_PER_MINUTE; attempt++) {
            admission.refusal("wrong", far, parser);
        }
        assertThat(admission.refusal(WORD, far, parser))
                .contains("too many wrong tokens came from this address; wait a minute");
        assertThat(admission.refusal(WORD, other, parser)).isEmpty();
        nanos.addAndGet(TimeUnit.MINUTES.toNanos(1));
        assertThat(admission.refusal(WORD, far, parser)).isEmpty();
    }

    @Test
    void wrongTokensOnThisComputerLockNoOneOut() {
        for (int attempt = 0; attempt < 100; attempt++) {
            assertThat(admission.refusal("wrong", near, parser)).isPresent();
        }
        assertThat(admission.refusal(WORD, near, parser)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "short", "two words of many letters", "0123456789abcdef012\u00e9"})
    void aTokenThatOthersCouldGuessIsRefused(String word) {
        assertThatThrownBy(() -> ListenToken.chosen(word))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("20 to 200 letters");
    }
}
