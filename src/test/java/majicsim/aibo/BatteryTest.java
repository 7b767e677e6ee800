package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What the battery does to the dog (URBI sheet, sections 2 and 16). */
class BatteryTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void withAnEmptyBatteryTheDogKeepsItsPostureAndSendsNothing() {
        client.ask("motors on; robot.stand(); robot.walk(10s),", 4000);
        bench.dog().handling().changeBattery(0);
        client.ask("", 4);
        double xMm = bench.dog().body().pose().xMm();

        assertThat(client.ask("1;", 1000)).isEmpty();
        assertThat(bench.dog().body().pose().xMm()).isEqualTo(xMm);
    }

    @Test
    void aDogWithoutPowerClosesConnectionsAndANewBatteryRestartsIt() {
        bench.dog().handling().changeBattery(0);
        Bench.Client late = bench.client();
        assertThat(late.isOpen()).isFalse();

        bench.dog().handling().changeBattery(0.5551);

        assertThat(bench.client().ask("power();")).containsExactly("[notag] 0.550000");
    }

    @Test
    void aLowOneIsSoundedOnce() {
        bench.dog().handling().changeBattery(0.2001);
        client.ask("", 20_000);

        assertThat(bench.dog().handling().played().stream()
                        .filter(each -> each.what().equals("battery.wav")))
                .hasSize(1);
    }

    @Test
    void theMonitorIsAScriptInEachConnectionThatAnyoneCanStop() {
        Bench.Client other = bench.client();
        assertThat(client.ask("stop power; power__shown;")).containsExactly("[notag] 87.000000");

        bench.dog().handling().changeBattery(0.505);

        assertThat(client.ask("")).isEmpty();
        assertThat(other.ask("")).isEmpty();
        assertThat(bench.client().ask("power__shown;")).containsExactly("[notag] 50.000000");
    }

    @Test
    void aStickWithAnotherClientScriptRunsThatInstead() {
        client.ask("save(\"CLIENT.INI\", \"hello: 1; x = 5;\");");
        Bench.Client late = bench.new Client();
        bench.dog().connected(late);
        late.take();
        bench.run(64);

        assertThat(late.take()).containsExactly("[hello] 1.000000");
        assertThat(late.ask("x;")).containsExactly("[notag] 5.000000");
    }
}
