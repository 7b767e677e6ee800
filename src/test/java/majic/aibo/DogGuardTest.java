package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import majic.bot.TimeSource;
import majic.link.Links;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class DogGuardTest {
    private static final String DISARMED = "1000000000000";

    private final Watch watch =
            new Watch(TimeSource.system(), TimeSource.system().signal());
    private ScriptedDog dog;
    private AiboLinks links;
    private DogGuard guard;

    @BeforeEach
    void install() throws IOException {
        dog = new ScriptedDog();
        links = new AiboLinks(() -> Links.of(dog.address(), AiboType.PORT, 0), watch, said -> {}, lost -> {});
        links.open();
        guard = new DogGuard(links, new Tags(), watch);
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
        guard.tend(false);

        assertThat(settings()).hasSize(2).last().asString().doesNotContain(DISARMED);
    }

    @Test
    void isDisarmedWhenNothingWalksSoLateAsARenewalWouldBeDue() {
        guard.renew();
        while (settings().size() < 3) {
            guard.tend(false);
        }

        assertThat(settings()).last().asString().contains(DISARMED);
    }

    /** What the guard's variable was set to up to now. */
    private List<String> settings() {
        Ask pong = new Ask("p", Ask.Expects.PONG);
        links.sensors().send(pong, "p: ping;");
        watch.await(pong::isDone, 5);
        return dog.received("alive = ");
    }
}
