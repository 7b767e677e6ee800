package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import majic.bot.BotAddress;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.RobotMessage;
import majic.shared.message.RobotState;
import majic.shared.message.ScanMessage;
import majic.shared.message.Sender;
import majic.shared.message.StateChange;
import majic.shared.message.ValueJson;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests how the states and changes of a shared robot become one state at the program that uses it. */
class ReceivedChangesTest {
    private static final String ROBOT = "lab/majic/1/desks/desk2/robots/1/";

    private final TestClock clock = new TestClock();
    private final FakeBroker broker = new FakeBroker(clock.time());
    private final FakeConnection desk = open("desk");
    private final FakeConnection user = open("user");
    private final List<RobotState> reported = new CopyOnWriteArrayList<>();
    private RobotFeed feed;

    private FakeConnection open(String client) {
        FakeConnection opened =
                broker.open(ConnectOptions.of(client, new BotEnvironment(clock.time(), Settings.inMemory())));
        opened.connect();
        return opened;
    }

    @BeforeEach
    void openTheFeed() {
        feed = new RobotFeed(
                new PooledBroker(user, Sender.ofThisRun("desk1", "Anna"), new AtomicLong()),
                SharedAddress.parse(BotAddress.parse("mqtt://broker/lab/desk2/1")),
                clock.time(),
                new Reports());
        feed.open();
    }

    @AfterEach
    void close() {
        feed.close();
        broker.close();
        clock.close();
    }

    /** Collects the states that are passed on. */
    private final class Reports implements RobotFeed.Listener {
        @Override
        public void described(Description description) {}

        @Override
        public void presenceKnown() {}

        @Override
        public void reported(RobotFeed.Received received) {
            reported.add(received.state());
        }

        @Override
        public void scanned(ScanMessage scan, long nanos, double ageS) {}

        @Override
        public void message(RobotMessage message) {}

        @Override
        public void gone(String reason) {}
    }

    private static RobotState state(long clockMs, double voltage, long stops) {
        return new RobotState(
                clockMs,
                new RobotState.Link(Connection.CONNECTED, ""),
                new RobotState.Movement(Pose.START, Pose.START, true, 0, 0, false, 0),
                false,
                stops,
                null,
                null,
                Map.of("voltage", ValueJson.of(Value.of(voltage, Unit.V)), "light", ValueJson.of(Value.onOff(true))));
    }

    private void publishState(RobotState state) {
        desk.publish(BrokerMessage.json(ROBOT + "state", state.toJson(), Quality.AT_MOST_ONCE)
                .retain());
    }

    private void publishChange(long clockMs, double voltage) {
        StateChange change =
                new StateChange(clockMs, 20, null, Map.of("voltage", ValueJson.of(Value.of(voltage, Unit.V))));
        desk.publish(BrokerMessage.json(ROBOT + "changes", change.toJson(), Quality.AT_MOST_ONCE));
    }

    private void until(int reports) {
        clock.until(() -> reported.size() >= reports);
        assertThat(reported).hasSize(reports);
    }

    private String voltage() {
        return Objects.requireNonNull(feed.state())
                .state()
                .values()
                .get("voltage")
                .toString();
    }

    @Test
    void aChangeReplacesItsValuesAndKeepsTheOthers() {
        publishState(state(1000, 12, 3));
        publishChange(1100, 11.5);
        until(2);

        assertThat(reported.get(1).values()).hasSize(2);
        assertThat(voltage()).isEqualTo("11.5");
        assertThat(reported.get(1).stops()).isEqualTo(3);
        assertThat(reported.get(1).motion().ageMs()).isEqualTo(20);
        assertThat(reported.get(1).clock()).isEqualTo(1100);
    }

    @Test
    void aChangeWithoutItsStateIsNotUsed() {
        publishChange(900, 11);
        publishState(state(1000, 12, 0));
        until(1);

        assertThat(voltage()).isEqualTo("12");
    }

    @Test
    void aChangeThatAStateHasOvertakenIsNotUsed() {
        publishState(state(1000, 12, 0));
        publishChange(900, 11);
        publishState(state(2000, 13, 0));
        until(2);

        assertThat(reported).extracting(RobotState::clock).containsExactly(1000L, 2000L);
    }

    @Test
    void aMessageThatWasLongerOnItsWayThanOthersIsOlder() throws InterruptedException {
        publishState(state(1000, 12, 0));
        until(1);
        user.holdBack();
        publishChange(1000, 11);
        clock.time().sleep(4);
        user.deliver();
        until(2);

        RobotFeed.Received late = Objects.requireNonNull(feed.state());
        assertThat(clock.time().secondsSince(late.nanos())).isLessThan(0.5);
        assertThat(clock.time().secondsSince(late.reportedNanos())).isBetween(4.0, 4.5);
    }

    @Test
    void aClockThatIsALittleFasterDoesNotMakeMessagesLate() {
        TransitTimes transit = new TransitTimes();
        long second = 1_000_000_000L;
        for (int i = 0; i < 100_000; i++) {
            assertThat(transit.lateNanos(i * 1000L, i * (second + 50_000))).isLessThan(1_000_000);
        }
    }
}
