package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What the battery does to the dog (URBI sheet, sections 2 and 16). */
class BatteryTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void withAnEmptyOneTheDogStandsAndIsSilent() {
        client.ask("motors on; robot.stand(); robot.walk(10s),", 4000);
        bench.dog().keeper().changeBattery(0);
        client.ask("", 4);
        double xMm = bench.dog().body().pose().xMm();

        assertThat(client.ask("1;", 1000)).isEmpty();
        assertThat(bench.dog().body().pose().xMm()).isEqualTo(xMm);
    }

    @Test
    void aDeadDogHangsUpAndANewBatteryWakesIt() {
        bench.dog().keeper().changeBattery(0);
        Bench.Client late = bench.client();
        assertThat(late.isOpen()).isFalse();

        bench.dog().keeper().changeBattery(0.5551);

        assertThat(bench.client().ask("power();")).containsExactly("[notag] 0.550000");
    }
}
