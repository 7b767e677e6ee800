package majic.aibo.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import majic.aibo.AiboType;
import majic.aibo.ScriptedDog;
import majic.aibo.urbi.AiboConnections;
import majic.aibo.urbi.DogClock;
import majic.aibo.urbi.LinkTransport;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiRequest;
import majic.driver.RobotWait;
import majic.link.Links;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class DogGuardTest {
    private static final int SENSORS = 1;
    private static final String DISARMED = "1000000000000";

    private ScriptedDog dog;
    private RobotWait waiting;
    private AiboConnections connections;
    private DogGuard guard;

    @BeforeEach
    void install() throws IOException {
        dog = new ScriptedDog();
        waiting = dog.waiting();
        connections = new AiboConnections(
                () -> new LinkTransport(Links.of(dog.address(), AiboType.PORT, 0), waiting.time()),
                waiting,
                said -> {},
                lost -> {});
        connections.open();
        guard = new DogGuard(connections, new Tags(), waiting, new DogClock(waiting.time()));
        guard.install();
    }

    @AfterEach
    void close() throws IOException {
        connections.abort();
        dog.close();
    }

    @Test
    void staysArmedBetweenItsRenewalAndTheWalkItIsFor() {
        guard.renew();
        guard.tick(null);

        assertThat(settings()).hasSize(2).last().asString().doesNotContain(DISARMED);
    }

    @Test
    void isDisarmedWhenNothingWalksSoLateAsARenewalWouldBeDue() {
        guard.renew();
        while (settings().size() < 3) {
            guard.tick(null);
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
    void aWalkThatIsBeingStoppedIsNeitherRenewedNorDisarmed() {
        guard.renew();
        RunningMotion stopped = walk(3000);
        stopped.requestStop();
        waiting.await(() -> false, 0.3);

        guard.tick(stopped);

        assertThat(settings()).hasSize(2).last().asString().doesNotContain(DISARMED);
    }

    private RunningMotion walk(int ms) {
        UrbiRequest ask = new UrbiRequest("w", UrbiRequest.Expects.END);
        RunningMotion walk =
                new RunningMotion(connections.motion(), ask, "w+begin+end: robot.walk(" + ms + "),", null).unknown();
        walk.start();
        dog.awaitReceived("robot.walk");
        return walk;
    }

    /** What the guard's variable was set to up to now. */
    private List<String> settings() {
        UrbiRequest pong = new UrbiRequest("p", UrbiRequest.Expects.PONG);
        connections.sensors().send(pong, "p: ping;");
        waiting.await(pong::isDone, 5);
        return dog.received("alive = ");
    }
}
