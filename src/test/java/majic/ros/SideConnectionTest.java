package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.ros.bridge.Arriving;
import majic.ros.bridge.BridgeAddress;
import majic.ros.bridge.RosBridge;
import majic.ros.bridge.TopicSubscription;
import majic.ros.readings.TopicSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A connection beside the one that drives the robot, with a server that is played by the test. */
class SideConnectionTest {
    private static final TopicSubscription SCAN = new TopicSubscription("/scan", "sensor_msgs/LaserScan", 100);

    @AutoClose
    private final ScriptedRos server = new ScriptedRos();

    private final List<JsonNode> messages = Collections.synchronizedList(new ArrayList<>());
    private final List<String> notices = Collections.synchronizedList(new ArrayList<>());
    private final AtomicInteger losses = new AtomicInteger();
    private volatile boolean refuses;
    private final SideConnection connection =
            new SideConnection("side", server.peer.clock().time(), new Opener());

    @AfterEach
    void close() {
        connection.abort();
    }

    private Runnable subscribe() {
        return subscribe(SCAN);
    }

    private Runnable subscribe(TopicSubscription wanted) {
        return connection.subscribe(wanted, new TopicSource.Receiver() {
            @Override
            public void message(JsonNode message, int bytes) {
                messages.add(message);
            }

            @Override
            public void lost() {
                losses.incrementAndGet();
            }
        });
    }

    private void until(BooleanSupplier condition) {
        server.peer.clock().until(condition);
    }

    private long subscriptions() {
        synchronized (server.peer) {
            return server.received.stream()
                    .filter(operation -> operation.path("op").asText().equals("subscribe"))
                    .count();
        }
    }

    /** The throttle of the newest request for the scan, ms. */
    private int throttleMs() {
        synchronized (server.peer) {
            return server.received.stream()
                    .filter(operation -> operation.path("op").asText().equals("subscribe"))
                    .mapToInt(operation -> operation.path("throttle_rate").asInt())
                    .reduce(-1, (before, newest) -> newest);
        }
    }

    private void publish() {
        server.publish("/scan", ScriptedRos.parse("{\"range_min\":0.1}"));
    }

    @Test
    void itIsOpenedByTheFirstSubscriptionAndClosedWhenNothingIsSubscribedToAnyMore() {
        assertThat(connection.activity()).isEmpty();
        Runnable end = subscribe();
        until(() -> server.isSubscribed("/scan"));
        publish();
        until(() -> messages.size() == 1);
        assertThat(connection.activity()).hasSize(1);

        end.run();
        until(() -> !server.isSubscribed("/scan"));
        until(() -> server.newest().path("op").asText().equals("close"));

        assertThat(connection.arriving()).isEqualTo(Arriving.NOTHING);
        assertThat(losses).hasValue(0);
    }

    @Test
    void afterItsLossTheReadingsAreNoneAndItIsOpenedAgain() {
        subscribe();
        until(() -> server.isSubscribed("/scan"));

        server.cut();
        until(() -> losses.get() == 1);
        long before = subscriptions();
        until(() -> subscriptions() > before);
        publish();

        until(() -> messages.size() == 1);
    }

    @Test
    void aServerThatFallsSilentIsLeftAndItIsOpenedAgain() {
        subscribe();
        until(() -> server.isSubscribed("/scan"));

        server.fallSilent();

        until(() -> losses.get() == 1);
        long before = subscriptions();
        until(() -> subscriptions() > before);
    }

    @Test
    void aServerThatRefusesItIsNamedOnceAndTriedAgain() {
        refuses = true;
        subscribe();
        until(() -> !notices.isEmpty());
        double fromS = seconds();
        until(() -> seconds() - fromS > 10);
        assertThat(notices)
                .containsExactly(
                        "what needs a further connection to the rosbridge server is not read, because it is full");

        refuses = false;

        until(() -> server.isSubscribed("/scan"));
    }

    @Test
    void theServerThrottlesAgainWhenTheSubscriptionWithoutAThrottleHasEnded() {
        subscribe();
        until(() -> throttleMs() == 100);
        Runnable end = subscribe(new TopicSubscription("/scan", "sensor_msgs/LaserScan", 0));
        until(() -> throttleMs() == 0);

        end.run();

        until(() -> throttleMs() == 100);
        assertThat(server.isSubscribed("/scan")).isTrue();
    }

    @Test
    void nothingIsSubscribedToAfterItsEnd() {
        connection.close(0);

        assertThatThrownBy(this::subscribe).isInstanceOf(LinkLost.class);
    }

    private double seconds() {
        return server.peer.clock().time().nanos() / 1e9;
    }

    /** Opens connections to the server of the test. */
    private final class Opener implements SideConnection.Opener {
        @Override
        public RosBridge open(Runnable lost) {
            if (refuses) {
                throw new BotException("it is full");
            }
            int port = Integer.parseInt(server.peer.address().replaceFirst(".*:", ""));
            return RosBridge.open(
                    new BridgeAddress("127.0.0.1", port, "/", false),
                    3000,
                    server.peer.clock().time(),
                    new RosBridge.Listener() {
                        @Override
                        public void lost(RosBridge bridge, LinkLost cause) {
                            lost.run();
                        }

                        @Override
                        public void notice(String message) {
                            notices.add(message);
                        }
                    });
        }

        @Override
        public void notice(String message) {
            notices.add(message);
        }
    }
}
