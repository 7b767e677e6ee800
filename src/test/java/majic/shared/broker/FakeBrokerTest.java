package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the faults of the broker in memory, which other tests rely on. */
class FakeBrokerTest {
    private static final BrokerMessage GONE = BrokerMessage.json("gone", "a", Quality.AT_LEAST_ONCE);

    @AutoClose
    private final TestClock clock = new TestClock();

    @AutoClose
    private final FakeBroker broker = new FakeBroker(clock.time());

    private final BotEnvironment environment = new BotEnvironment(clock.time(), Settings.inMemory());
    private final FakeConnection a =
            broker.open(ConnectOptions.of("a", environment).withWill(GONE));
    private final FakeConnection b = broker.open(ConnectOptions.of("b", environment));
    private final List<String> heard = new ArrayList<>();

    @BeforeEach
    void connect() {
        a.connect();
        b.connect();
        b.subscribe("#", Quality.AT_LEAST_ONCE, message -> hear(message.topic() + " " + message.text()));
        clock.until(b::isConnected);
    }

    private synchronized void hear(String what) {
        heard.add(what);
    }

    private synchronized List<String> heard() {
        return List.copyOf(heard);
    }

    private static BrokerMessage message(String text) {
        return BrokerMessage.json("t", text, Quality.AT_LEAST_ONCE);
    }

    private void heardAre(String... messages) {
        clock.until(() -> heard().equals(List.of(messages)));
    }

    @Test
    void messagesArriveInTheirOrder() {
        a.publish(message("1"));
        a.publish(message("2"));

        heardAre("t 1", "t 2");
    }

    @Test
    void whatIsHeldBackArrivesAtOnceAndInItsOrder() {
        a.holdBack();
        a.publish(message("1"));
        a.publish(message("2"));
        clock.until(() -> clock.time().nanos() > 10e9);
        assertThat(heard()).isEmpty();

        a.deliver();

        heardAre("t 1", "t 2");
    }

    @Test
    void aCutCableIsNoticedAfterOneAndAHalfTimesTheKeepAliveAndPublishesTheWill() {
        a.publish(message("1"));
        heardAre("t 1");
        long before = clock.time().nanos();
        a.cut();
        a.publish(message("2"));

        heardAre("t 1", "gone a");

        assertThat(clock.time().secondsSince(before)).isBetween(1.5, 1.6);
        assertThat(a.isConnected()).isFalse();
        assertThatThrownBy(() -> a.publish(message("3"))).isInstanceOf(BotException.class);
    }

    @Test
    void aCableThatIsPluggedInAgainInTimeLosesNothing() {
        a.cut();
        a.publish(message("1"));
        a.restore();

        heardAre("t 1");
        clock.until(() -> clock.time().nanos() > 10e9);
        assertThat(heard()).containsExactly("t 1");
    }

    @Test
    void aLostConnectionIsMadeAgainWithItsSubscriptions() {
        List<String> watched = new ArrayList<>();
        b.watch(new BrokerConnection.Watcher() {
            @Override
            public void connected() {
                hear("connected");
            }

            @Override
            public void lost(String reason) {
                watched.add(reason);
            }
        });
        b.drop();
        clock.until(b::isConnected);
        a.publish(message("1"));

        heardAre("connected", "connected", "t 1");
        assertThat(watched).containsExactly("the connection was reset");
    }

    @Test
    void aKilledClientLeavesItsWillAndDoesNotReturn() {
        a.kill();

        heardAre("gone a");
        clock.until(() -> clock.time().nanos() > 10e9);
        assertThat(a.isConnected()).isFalse();
    }

    @Test
    void aClosedClientLeavesNoWill() {
        a.close();

        clock.until(() -> clock.time().nanos() > 10e9);
        assertThat(heard()).isEmpty();
    }

    @Test
    void aStoppedBrokerRefusesClientsUntilItIsStarted() {
        broker.stop();
        FakeConnection late = broker.open(ConnectOptions.of("late", environment));

        assertThatThrownBy(late::connect).isInstanceOf(ConnectFailed.class);
        clock.until(() -> clock.time().nanos() > 5e9);
        assertThat(a.isConnected()).isFalse();
        broker.start();
        clock.until(() -> a.isConnected() && b.isConnected());
    }

    @Test
    void aRetainedMessageIsDeliveredUntilItExpires() {
        broker.publish(message("kept").retain().expiringAfter(3));
        heardAre("t kept");
        a.subscribe("t", Quality.AT_MOST_ONCE, message -> hear("a " + message.retained()));
        heardAre("t kept", "a true");

        clock.until(() -> clock.time().nanos() > 4e9);

        assertThat(broker.retained("t")).isEmpty();
    }

    @Test
    void aMessageArrivesTwiceOnDemand() {
        broker.repeat();
        a.publish(message("1"));

        heardAre("t 1", "t 1");
    }

    @Test
    void aSubscriptionThatIsNotAcknowledgedFails() {
        b.holdBack();

        assertThatThrownBy(() -> b.subscribe("t", Quality.AT_LEAST_ONCE, message -> {}))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("does not answer");
    }
}
