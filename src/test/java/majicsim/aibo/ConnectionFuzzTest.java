package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;

/**
 * Whatever program a client runs: found and kept ones in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class ConnectionFuzzTest {
    /** What opens a string, a comment or a binary would swallow the way out of it too. */
    private static final String SWALLOWING = "[\"#/\\\\bB]";

    @FuzzTest
    void aConnectionLivesOnAfterAnyProgram(byte[] program) {
        Bench bench = Bench.exact();
        Bench.Client client = bench.client();
        Bench.Client other = bench.client();

        String tamed = new String(program, StandardCharsets.ISO_8859_1).replaceAll(SWALLOWING, "c");
        client.ask(tamed, 64);
        client.say("$$;");
        other.ask("stopall;", 64);
        client.take();
        other.take();

        assertThat(other.ask("1;")).contains("[notag] 1.000000");
        if (client.isOpen()) {
            assertThat(client.ask("1;")).contains("[notag] 1.000000");
        }
    }
}
