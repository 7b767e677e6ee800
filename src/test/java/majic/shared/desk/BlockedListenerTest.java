package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import majic.bot.FakeBot;
import majic.bot.Unit;
import majic.bot.Value;
import majic.shared.broker.Quality;
import majic.shared.message.RequestedAction;
import majic.shared.message.SiteTopics.Part;
import majic.team.TeamListener;
import majic.time.Signal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the messages of the holder while a listener of the team blocks the worker of the desk. */
class BlockedListenerTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();
    private final Signal released = rig.clock.time().signal();
    private volatile boolean blocked;
    private volatile boolean isReleased;

    @BeforeEach
    void holdTheRobotAndBlockTheWorker() {
        anna.drive(200);
        rig.clock.until(() -> bot.sent().contains("drive 200 0"));
        rig.team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String message) {
                awaitRelease();
            }
        });
        anna.publish(Part.REQUEST, "nonsense".getBytes(StandardCharsets.UTF_8), Quality.AT_LEAST_ONCE, "");
        rig.clock.until(() -> blocked);
    }

    private void awaitRelease() {
        blocked = true;
        try {
            released.await(() -> isReleased, Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @AfterEach
    void release() {
        isReleased = true;
        released.raise();
    }

    @Test
    void speedsAndMotionsOfTheHolderReachTheRobot() {
        anna.drive(300);
        rig.clock.until(() -> bot.sent().contains("drive 300 0"));

        anna.move(500);
        rig.clock.until(() -> bot.sent().contains("move 500"));
    }

    @Test
    void aMotionDoesNotOvertakeARequestThatWaits() {
        anna.ask(new RequestedAction.Set("headPan", List.of(Value.of(30, Unit.NONE))));
        anna.move(500);
        rig.sleep(0.5);
        assertThat(bot.sent()).doesNotContain("headPan 30", "move 500");

        release();
        rig.clock.until(() -> bot.sent().contains("move 500"));
        assertThat(bot.sent()).containsSubsequence("headPan 30", "move 500");
    }

    @Test
    void aMotionOfAnotherUserIsNotBegun() {
        RemoteUser carl = rig.user("desk3", "Carl");
        carl.move(700);
        rig.sleep(0.5);

        assertThat(bot.sent()).doesNotContain("move 700");
    }
}
