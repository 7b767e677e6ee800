package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Objects;
import java.util.OptionalLong;
import java.util.Set;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.Request;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests with the protocol of a Pioneer that a robot comes to rest when its holder at another desk is gone. */
class HeldPioneerInLabTest {
    private static final double SPEED_MM_PER_S = 300;

    /** A Pioneer brakes with 300 mm/s² unless it is set otherwise, and reports ten times a second. */
    private static final double BRAKING_S = SPEED_MM_PER_S / 300 + 0.3;

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final TimeSource time = rig.team().time();
    private final FakeBroker broker = new FakeBroker(time);
    private final MajicBot bot = rig.add("pioneer");
    private final Sender anna = Sender.ofThisRun("desk1", "Anna");
    private final SiteTopics topics = new SiteTopics("lab");
    private final FakeConnection user = open("desk1", null);
    private volatile @Nullable RobotState state;
    private volatile boolean beating = true;

    private FakeConnection open(String clientId, @Nullable BrokerMessage will) {
        return broker.open(new ConnectOptions(
                clientId, will, 1, ConnectOptions.TIMEOUT_MS, new BotEnvironment(time, Settings.inMemory())));
    }

    @AutoClose
    private final DeskSharing sharing = new DeskSharing(
            rig.team(), new DeskOptions("lab", "desk2", "Bob", "MAJIC test", Set.of(), false), this::open);

    @BeforeEach
    void driveFromTheOtherDesk() throws InterruptedException {
        sharing.start();
        user.subscribe(topics.robot("desk2", 1, Part.STATE), Quality.AT_MOST_ONCE, message -> {
            state = RobotState.parse(message.payload());
            rig.team().changes().raise();
        });
        user.connect();
        assertThat(rig.await(() -> state != null)).isTrue();
        bot.set("cruise", SPEED_MM_PER_S);
        time.thread("heartbeats", this::beat).start();
        long validUntil = Objects.requireNonNull(state).clock() + 1000;
        Request move = new Request(anna, 1, OptionalLong.of(validUntil), new RequestedAction.Move(3000, ""));
        user.publish(BrokerMessage.json(topics.robot("desk2", 1, Part.REQUEST), move.toJson(), Quality.AT_LEAST_ONCE));
        assertThat(rig.await(() -> bot.state().speedMmPerSec() > 0.9 * SPEED_MM_PER_S))
                .isTrue();
    }

    private void beat() {
        try {
            while (beating && user.isConnected()) {
                long validUntil = Objects.requireNonNull(state).clock() + 700;
                user.publish(BrokerMessage.json(
                        topics.robot("desk2", 1, Part.HOLD),
                        new HoldMessage(anna, validUntil).toJson(),
                        Quality.AT_MOST_ONCE));
                time.sleep(0.25);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Waits until the robot is stationary; returns how long that takes, seconds. */
    private double secondsUntilStationary() throws InterruptedException {
        long begin = time.nanos();
        assertThat(rig.await(() -> !bot.state().moving() && bot.state().speedMmPerSec() == 0))
                .isTrue();
        return time.secondsSince(begin);
    }

    private void staysWhereItIs() throws InterruptedException {
        Pose stopped = rig.truePose("pioneer");
        time.sleep(5);
        assertThat(rig.truePose("pioneer")).isEqualTo(stopped);
        assertThat(rig.team().member(1).owner()).isNull();
        assertThat(rig.team().member(1).isIdle()).isTrue();
    }

    @Test
    void aPioneerStandsOneSecondAndItsBrakingAfterTheLastHeartbeat() throws InterruptedException {
        beating = false;

        assertThat(secondsUntilStationary()).isBetween(0.7, RobotHold.HEARTBEAT_S + BRAKING_S);
        staysWhereItIs();
    }

    @Test
    void aPioneerBrakesAtOnceWhenItsBrokerIsGone() throws InterruptedException {
        broker.stop();

        assertThat(secondsUntilStationary()).isLessThan(BRAKING_S);
        staysWhereItIs();
    }

    @Test
    void aPioneerStandsAfterItsUserWasKilled() throws InterruptedException {
        user.kill();

        assertThat(secondsUntilStationary()).isLessThan(RobotHold.HEARTBEAT_S + BRAKING_S);
        staysWhereItIs();
    }
}
