package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import majic.aibo.session.AiboSession;
import majic.bot.LinkLost;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connections that end while the dog walks. */
@Timeout(30)
class LostDogTest {
    private static final int STOP = 0;
    private static final int MOTION = 2;

    @AutoClose
    private Dogs dogs;

    @BeforeEach
    void connect() throws IOException {
        dogs = new Dogs();
        dogs.aibo.connect();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void oneOfThreeConnectionsLostEndsTheWalkWithAStopOverAnother(int connection) {
        CompletableFuture<Void> walk = walk();

        dogs.dog.hangUp(connection);

        assertThatThrownBy(() -> dogs.join(walk))
                .hasCauseInstanceOf(LinkLost.class)
                .hasMessageContaining("the dog closed it");
        dogs.dog.awaitReceived("stop walk");
        assertThat(dogs.aibo.isConnected()).isFalse();
        assertThat(dogs.dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void whatALostConnectionLeftGoingOnIsEndedByTheNextOneAndNothingResumes() {
        CompletableFuture<Void> walk = walk();
        dogs.dog.hangUp();
        assertThatThrownBy(() -> dogs.join(walk)).hasCauseInstanceOf(LinkLost.class);
        int before = dogs.dog.received("stop walk").size();

        dogs.aibo.connect();

        assertThat(dogs.dog.received("stop walk").size()).isGreaterThan(before);
        assertThat(dogs.dog.received("stop mj")).isNotEmpty();
        assertThat(dogs.dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aDogThatStoodStillIsLeftAloneByTheNextConnection() {
        dogs.dog.hangUp();
        dogs.until(() -> !dogs.aibo.isConnected());

        dogs.aibo.connect();

        assertThat(dogs.dog.received("stop walk")).hasSizeLessThanOrEqualTo(1);
    }

    @Test
    void aCommandToALostDogFailsWithTheCauseOfTheLoss() {
        dogs.dog.hangUp(MOTION);
        dogs.until(() -> !dogs.aibo.isConnected());

        assertThatThrownBy(dogs.aibo::halt)
                .isInstanceOf(LinkLost.class)
                .hasMessage("connection lost: the dog closed it");
        assertThatThrownBy(() -> dogs.aibo.get("ledF1")).hasMessage("connection lost: the dog closed it");
    }

    @Test
    void aStopOverADeadConnectionDoesNotClaimToHaveWaited() {
        AiboSession session = dogs.aibo.session();
        dogs.dog.hangUp(STOP);
        dogs.until(() -> !dogs.aibo.isConnected());

        assertThatThrownBy(() -> session.executor().confirm()).isInstanceOf(LinkLost.class);
    }

    private CompletableFuture<Void> walk() {
        CompletableFuture<Void> walk = dogs.aside(() -> dogs.aibo.move(2000));
        dogs.dog.awaitReceived("robot.walk(");
        return walk;
    }
}
