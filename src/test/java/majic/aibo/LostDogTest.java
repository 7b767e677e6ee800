package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.concurrent.CompletableFuture;
import majic.aibo.session.AiboSession;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connections that end while the dog walks. */
class LostDogTest {
    private static final int STOP = 0;
    private static final int MOTION = 2;

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.standing().connected();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void oneOfThreeConnectionsLostEndsTheWalkWithAStopOverAnother(int connection) {
        CompletableFuture<Void> walk = walk();

        dog.hangUp(connection);

        assertThatThrownBy(() -> driven.join(walk))
                .hasCauseInstanceOf(LinkLost.class)
                .hasMessageContaining("the dog closed it");
        dog.awaitReceived("stop walk");
        assertThat(aibo.isConnected()).isFalse();
        assertThat(dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void aMotionLeftByALostConnectionIsEndedByTheNextOneAndNothingResumes() {
        CompletableFuture<Void> walk = walk();
        dog.hangUp();
        assertThatThrownBy(() -> driven.join(walk)).hasCauseInstanceOf(LinkLost.class);
        int before = dog.received("stop walk").size();

        aibo.connect();

        assertThat(dog.received("stop walk").size()).isGreaterThan(before);
        assertThat(dog.received("stop mj")).isNotEmpty();
        assertThat(dog.received("robot.walk(")).hasSize(1);
    }

    @Test
    void theLastReadingsAreShownUntilTheDogIsConnectedAgain() {
        dog.hangUp();
        driven.until(() -> !aibo.isConnected());
        Map<String, String> last = aibo.displayState();
        dog.trouble(STOP, ScriptedDog.Trouble.HANGS_UP);

        assertThatThrownBy(aibo::connect).isInstanceOf(ConnectFailed.class);

        assertThat(last).isNotEmpty();
        assertThat(aibo.displayState()).isEqualTo(last);
    }

    @Test
    void theNextConnectionDoesNotStopADogThatDidNotWalk() {
        dog.hangUp();
        driven.until(() -> !aibo.isConnected());

        aibo.connect();

        assertThat(dog.received("stop walk")).hasSizeLessThanOrEqualTo(1);
    }

    @Test
    void aCommandToALostDogFailsWithTheCauseOfTheLoss() {
        dog.hangUp(MOTION);
        driven.until(() -> !aibo.isConnected());

        assertThatThrownBy(aibo::halt).isInstanceOf(LinkLost.class).hasMessage("connection lost: the dog closed it");
        assertThatThrownBy(() -> aibo.set("ledF1", 1)).hasMessage("connection lost: the dog closed it");
        assertThat(aibo.get("ledF1")).isEqualTo(Value.unknown("connection lost"));
    }

    @Test
    void aStopOverALostConnectionReportsNoConfirmation() {
        AiboSession session = aibo.session();
        dog.hangUp(STOP);
        driven.until(() -> !aibo.isConnected());

        assertThatThrownBy(() -> session.executor().confirm()).isInstanceOf(LinkLost.class);
    }

    private CompletableFuture<Void> walk() {
        CompletableFuture<Void> walk = driven.aside(() -> aibo.move(2000));
        dog.awaitReceived("robot.walk(");
        return walk;
    }
}
