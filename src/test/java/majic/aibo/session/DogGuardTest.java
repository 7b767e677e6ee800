package majic.aibo.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import majic.aibo.AiboType;
import majic.aibo.ScriptedDog;
import majic.aibo.urbi.AiboLinks;
import majic.aibo.urbi.Ask;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.Watch;
import majic.link.Links;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class DogGuardTest {
    private static final int SENSORS = 1;
    private static final String DISARMED = "1000000000000";

    private ScriptedDog dog;
    private Watch watch;
    private AiboLinks links;
    private DogGuard guard;

    @BeforeEach
    void install() throws IOException {
        dog = new ScriptedDog();
        watch = dog.watch();
        links = new AiboLinks(() -> Links.of(dog.address(), AiboType.PORT, 0), watch, said -> {}, lost -> {});
        links.open();
        guard = new DogGuard(links, new Tags(), watch, new DogClock(watch));
        guard.install();
    }

    @AfterEach
    void close() throws IOException {
        links.abort();
        dog.close();
    }

    @Test
    void staysArmedBetweenItsRenewalAndTheWalkItIsFor() {
        guard.renew();
        guard.tend(null);

        assertThat(settings()).hasSize(2).last().asString().doesNotContain(DISARMED);
    }

    @Test
    void isDisarmedWhenNothingWalksSoLateAsARenewalWouldBeDue() {
        guard.renew();
        while (settings().size() < 3) {
            guard.tend(null);
        }

        assertThat(settings()).last().asString().contains(DISARMED);
    }

    @Test
    void endsAWalkWhoseRenewalsDoNotArriveAnyMore() {
        walk(8000);
        guard.renew();
        assertThat(settings()).hasSize(2);
        dog.stopReading(SENSORS);

        dog.clock().until(() -> !dog.isWalking());

        assertThat(dog.guardEnded).hasValue(1);
    }

    @Test
    void leavesAWalkThatWasToldToStopToItself() {
        guard.renew();
        Running stopped = walk(3000);
        stopped.requestStop();
        watch.await(() -> false, 0.3);

        guard.tend(stopped);

        assertThat(settings()).hasSize(2).last().asString().doesNotContain(DISARMED);
    }

    private Running walk(int ms) {
        Ask ask = new Ask("w", Ask.Expects.END);
        Running walk = new Running(links.motion(), ask, "w+begin+end: robot.walk(" + ms + "),", null).unknown();
        walk.start();
        dog.awaitReceived("robot.walk");
        return walk;
    }

    /** What the guard's variable was set to up to now. */
    private List<String> settings() {
        Ask pong = new Ask("p", Ask.Expects.PONG);
        links.sensors().send(pong, "p: ping;");
        watch.await(pong::isDone, 5);
        return dog.received("alive = ");
    }
}
