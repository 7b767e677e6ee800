package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Connecting, several clients, and leaving (URBI sheet, sections 2, 5 and 17). */
class ClientTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();
    private final Bench.Client other = bench.client();

    @Test
    void theBannerIdentityAndBatteryComeFirst() {
        Bench.Client late = bench.new Client();
        bench.dog().connected(late);
        List<String> banner = late.take();
        bench.run(32);

        assertThat(banner)
                .filteredOn(line -> line.startsWith("[start] ***"))
                .hasSizeBetween(10, 13)
                .hasSize(banner.size() - 1);
        assertThat(banner).anyMatch(line -> line.startsWith("[start] *** URBI Kernel version 1.0 rev. "));
        assertThat(banner.get(banner.size() - 1)).matches("\\[ident] \\*\\*\\* ID: U\\d{9,}");
        assertThat(late.take()).containsExactly("[power] *** Battery at 87 %");
    }

    @Test
    void everyLineHasTheTimeOfTheServer() {
        client.say("1;");
        String first = client.raw();
        bench.run(1000);
        client.say("1;");

        assertThat(first).matches("\\[\\d{8}:notag] 1\\.000000\n");
        assertThat(stamp(client.raw()) - stamp(first)).isEqualTo(1000);
    }

    @Test
    void bareNamesBelongToAConnectionAndDottedOnesToAll() {
        assertThat(client.ask("x = 5; x; robot.x = 6;")).containsExactly("[notag] 5.000000");

        assertThat(other.ask("robot.x;")).containsExactly("[notag] 6.000000");
        assertThat(other.ask("x;").get(0)).matches("\\[notag] !!! Unknown identifier: U\\d{9,}\\.x");
    }

    @Test
    void oneClientsWaitDelaysNoOther() {
        client.say("wait(3s); echo \"queued behind wait\";");

        assertThat(other.ask("echo \"B not blocked\";")).containsExactly("[notag] *** B not blocked");
        assertThat(client.take()).isEmpty();
        assertThat(client.ask("", 3000)).containsExactly("[notag] *** queued behind wait");
    }

    @Test
    void anEchoCanGoToAll() {
        other.say("echo \"to all\" connection:\"all\"; echo \"to others\" connection:\"other\";");

        assertThat(client.take()).containsExactly("[notag] *** to all", "[notag] *** to others");
        assertThat(other.take()).containsExactly("[notag] *** to all");
    }

    @Test
    void quitClosesTheLineAfterWhatWasSentBefore() {
        assertThat(client.ask("1; quit; 2;")).containsExactly("[notag] 1.000000");

        assertThat(client.isOpen()).isFalse();
        assertThat(other.ask("connections;")).hasSize(2);
    }

    @Test
    void commandsOfAClosedConnectionEnd() {
        client.say("motors on; at (headPan.val > 10) { headPan.val = 0 },");
        client.hangUp();

        assertThat(other.ask("headPan.val = 20; wait(200); headPan.val;", 400)).containsExactly("[notag] 20.000000");
    }

    @Test
    void theBatteryIsReportedWithEveryPercent() {
        assertThat(client.ask("power();", 120_000))
                .containsExactly("[notag] 0.870000", "[power] *** Battery at 86 %", "[power] *** Battery at 85 %");
    }

    private static long stamp(String line) {
        return Long.parseLong(line.substring(1, 9));
    }
}
