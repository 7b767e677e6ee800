package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majicsim.world.Pose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Walking and turning: how far, how long, and how it is ended. */
class WalkTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @BeforeEach
    void standUp() {
        assertThat(client.ask("motors on; st+end: robot.stand();", 3300)).containsExactly("[st] *** end");
    }

    @ParameterizedTest
    @ValueSource(ints = {12_000, -6_000, 1_203, 5})
    void anExactDogWalksTwelveMillisecondsAMillimetre(int ms) {
        client.ask("mv+end: robot.walk(" + ms + ");", Math.abs(ms) + 100.0);

        assertThat(bench.dog().body().pose().xMm()).isCloseTo(ms / 12.0, within(0.01));
    }

    @ParameterizedTest
    @ValueSource(ints = {2_502, -2_502, 999})
    void anExactDogTurnsThirtySixDegreesASecond(int ms) {
        client.ask("tr+end: robot.turn(" + ms + ");", Math.abs(ms) + 100.0);

        assertThat(bench.dog().body().pose().headingDeg()).isCloseTo(ms * 0.036, within(0.01));
    }

    @Test
    void theEndComesAtTheCycleAfterTheTime() {
        assertThat(client.ask("mv+begin+end: robot.walk(2000);", 1996)).containsExactly("[mv] *** begin");
        bench.run(64);
        assertThat(client.take()).containsExactly("[mv] *** end");
    }

    @Test
    void aWalkHoldsBackWhatFollowsOnItsOwnConnectionOnly() {
        Bench.Client other = bench.client();
        client.ask("robot.walk(1000); 1;", 500);

        assertThat(client.take()).isEmpty();
        assertThat(other.ask("2;")).containsExactly("[notag] 2.000000");
        bench.run(600);
        assertThat(client.take()).containsExactly("[notag] 1.000000");
    }

    @ParameterizedTest
    @ValueSource(strings = {"stop walk;", "robot.stopwalk();"})
    void aStoppedWalkSendsItsCallersEnd(String stop) {
        Bench.Client other = bench.client();
        client.say("mv+end: robot.walk(10s);");
        bench.run(1000);

        other.say(stop);

        assertThat(client.take()).isEmpty();
        bench.run(64);
        assertThat(client.take()).containsExactly("[mv] *** end");
        assertThat(bench.dog().body().pose().xMm()).isCloseTo(83.333, within(0.01));
    }

    @Test
    void stoppingTheCallersTagSendsNoEnd() {
        client.ask("mv+end: robot.walk(10s),", 1000);
        Pose stopped = bench.dog().body().pose();

        List<String> lines = client.ask("stop mv;", 500);

        assertThat(lines).isEmpty();
        assertThat(bench.dog().body().pose()).isEqualTo(stopped);
    }

    @Test
    void aFrozenWalkPausesAndContinuesForTheRestOfItsTime() {
        client.ask("mv+end: robot.walk(2000),", 1000);
        client.ask("freeze mv;", 3000);
        double halfway = bench.dog().body().pose().xMm();

        List<String> lines = client.ask("unfreeze mv;", 1100);

        assertThat(halfway).isCloseTo(83.333, within(0.01));
        assertThat(lines).containsExactly("[mv] *** end");
        assertThat(bench.dog().body().pose().xMm()).isCloseTo(166.666, within(0.01));
    }

    @Test
    void aWalkAndATurnAtOnceAreAveraged() {
        client.ask("robot.walk(1000) & robot.turn(1000);", 1100);

        assertThat(bench.dog().body().pose().headingDeg()).isCloseTo(18, within(0.01));
    }

    @Test
    void withLooseMotorsTheGaitRunsButTheDogStays() {
        List<String> lines = client.ask("motors off; mv+end: robot.walk(1000);", 1100);

        assertThat(lines).containsExactly("[mv] *** end");
        assertThat(bench.dog().body().pose().xMm()).isZero();
    }

    @Test
    void onItsBackTheLegsGoButTheDogStays() {
        bench.dog().handling().roll(180);

        assertThat(client.ask("mv+end: robot.walk(1000);", 1100)).containsExactly("[mv] *** end");
        assertThat(bench.dog().body().pose().xMm()).isZero();
    }

    @Test
    void aWalkEndsWithItsConnection() {
        Bench.Client other = bench.client();
        other.ask("robot.walk(10s);", 1000);

        other.hangUp();
        bench.run(1000);

        assertThat(bench.dog().body().pose().xMm()).isCloseTo(83.333, within(0.01));
    }

    @Test
    void twoClientsWalkingItForwardMoveItOnce() {
        Bench.Client other = bench.client();
        client.say("robot.walk(1000);");
        other.ask("robot.walk(1000);", 1100);

        assertThat(bench.dog().body().pose().xMm()).isCloseTo(83.333, within(0.01));
    }

    @Test
    void aRealDogIsOffByItsStepsAndSlowerBackward() {
        Bench real = Bench.noisy(7);
        Bench.Client keeper = real.client();
        keeper.ask("motors on; robot.stand();", 3300);
        keeper.ask("robot.walk(12000);", 12_100);
        double ahead = real.dog().body().pose().xMm();
        keeper.ask("robot.walk(-12000);", 12_100);

        assertThat(ahead).isBetween(900.0, 1100.0).isNotCloseTo(1000, within(0.5));
        assertThat(real.dog().body().pose().xMm()).isBetween(50.0, 350.0);
    }
}
