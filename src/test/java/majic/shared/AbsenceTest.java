package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotAddress;
import majic.bot.BotProfile;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Range;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.Presence;
import majic.shared.message.RobotMessage;
import majic.shared.message.RobotState;
import majic.shared.message.ScanMessage;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the reasons for which a shared robot cannot be connected. */
class AbsenceTest {
    private static final Sender BERT = new Sender("desk2", "Bert", "s-2");
    private static final SiteTopics TOPICS = new SiteTopics("lab");

    @AutoClose
    private final TestClock clock = new TestClock();

    @AutoClose
    private final FakeBroker broker = new FakeBroker(clock.time());

    private final SharedAddress address = SharedAddress.parse(BotAddress.parse("mqtt://broker/lab/desk2/1"));
    private final FakeConnection connection =
            broker.open(ConnectOptions.of("user", new BotEnvironment(clock.time(), Settings.inMemory())));
    private final RobotFeed feed = new RobotFeed(
            new PooledBroker(connection, new Sender("desk1", "Anna", "s-1"), new AtomicLong()),
            address,
            clock.time(),
            new NoListener());

    @BeforeEach
    void subscribe() {
        connection.connect();
        feed.open();
    }

    private void publish(String topic, byte[] payload) {
        broker.publish(BrokerMessage.json(topic, payload, Quality.AT_LEAST_ONCE));
    }

    private void publishPresence(Integer... robots) {
        Presence online = new Presence(Presence.State.ONLINE, BERT, "MAJIC", List.of(robots));
        publish(TOPICS.presence("desk2"), online.toJson());
        clock.until(() -> feed.presence() != null);
    }

    private void publishDescription() {
        Description pioneer = new Description(
                BERT.session(),
                "",
                new Description.Kind("pioneer", "Pioneer", "MobileRobots Pioneer"),
                "a MobileRobots Pioneer",
                new BotProfile(250, Range.ANY, Range.ANY, 100, 45, 300, false),
                false,
                List.of(),
                List.of(),
                List.of(),
                List.of());
        publish(TOPICS.robot("desk2", 1, Part.DESCRIPTION), pioneer.toJson());
        clock.until(() -> feed.description() != null);
    }

    private void publishState(Connection link, String lostReason) {
        RobotState state = new RobotState(
                5,
                new RobotState.Link(link, lostReason),
                new RobotState.Movement(Pose.START, Pose.START, false, 0, 0, false, 0),
                false,
                0,
                null,
                null,
                Map.of());
        publish(TOPICS.robot("desk2", 1, Part.STATE), state.toJson());
        clock.until(() -> feed.state() != null);
    }

    private String absence() {
        return Absence.of(address, feed);
    }

    @Test
    void isADeskThatSharesNothingOrOtherRobots() {
        assertThat(absence()).startsWith("no desk desk2 shares robots at mqtt://broker");

        publishPresence(2, 3);

        assertThat(absence()).isEqualTo("desk2 shares no robot 1 (it shares 2, 3); is the number right?");
    }

    @Test
    void isAMessageThatNeverArrives() {
        publishPresence(1);
        assertThat(absence()).contains("never describes it");

        publishDescription();

        assertThat(absence()).contains("never reports the state of it");
    }

    @Test
    void isTheLossOfTheRobotAtItsDesk() {
        publishPresence(1);
        publishDescription();
        publishState(Connection.LOST, "cable pulled");

        assertThat(absence())
                .isEqualTo(
                        "desk2 is not connected to its robot 1 at the moment: cable pulled; is it switched on, and connected"
                                + " there?");
    }

    @Test
    void isTheLossOfTheBrokerWhateverHasArrivedBefore() {
        publishPresence(1);
        publishDescription();

        connection.drop();
        clock.until(feed::isOver);

        assertThat(absence()).startsWith("the connection to the broker was lost: ");
    }

    @Test
    void isTheRemovalOfTheRobotWhileItIsConnected() {
        publishPresence(1);
        publishDescription();
        publishState(Connection.CONNECTED, "");

        publish(TOPICS.robot("desk2", 1, Part.DESCRIPTION), new byte[0]);
        clock.until(feed::isOver);

        assertThat(absence()).isEqualTo("desk2 has removed its robot 1");
    }

    /** Ignores all events: the tests read the feed. */
    private static final class NoListener implements RobotFeed.Listener {
        @Override
        public void described(Description description) {}

        @Override
        public void presenceKnown() {}

        @Override
        public void reported(RobotFeed.Received received) {}

        @Override
        public void scanned(ScanMessage scan, long nanos, double ageS) {}

        @Override
        public void message(RobotMessage message) {}

        @Override
        public void gone(String reason) {}
    }
}
