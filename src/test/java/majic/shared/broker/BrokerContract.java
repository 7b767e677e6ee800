package majic.shared.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.time.WaitLimit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** What every broker and every connection does. Each test uses topics of its own. */
abstract class BrokerContract {
    private static final String ONLINE = "connected";

    /** On a computer that stalls, a broker would take a client with a short one for lost. */
    private static final int KEEP_ALIVE_SECONDS = 60;

    final BlockingQueue<BrokerMessage> arrived = new LinkedBlockingQueue<>();

    /** Creates a connection with a name of its own. */
    abstract BrokerConnection open(ConnectOptions options);

    /** Breaks a connection so that both ends notice at once; it cannot be made again before {@link #restore}. */
    abstract void cut(BrokerConnection connection);

    abstract void restore(BrokerConnection connection);

    BrokerConnection connected(String name, @Nullable BrokerMessage will) {
        ConnectOptions options = ConnectOptions.of(name + "-" + topic("id").hashCode(), BotEnvironment.plain())
                .withTimeoutMs(WaitLimit.MS);
        BrokerConnection connection =
                open((will == null ? options : options.withWill(will)).withKeepAlive(KEEP_ALIVE_SECONDS));
        connection.connect();
        return connection;
    }

    String topic(String name) {
        return "test/" + System.identityHashCode(this) + "/" + name;
    }

    static BrokerMessage message(String topic, String text) {
        return BrokerMessage.json(topic, text, Quality.AT_LEAST_ONCE);
    }

    BrokerMessage next() throws InterruptedException {
        BrokerMessage next = arrived.poll(WaitLimit.SECONDS, TimeUnit.SECONDS);
        assertThat(next).as("a message").isNotNull();
        return next;
    }

    @Test
    void aRequestArrivesWithAllItsPartsAndIsAnswered() throws Exception {
        try (BrokerConnection asking = connected("asking", null);
                BrokerConnection answering = connected("answering", null)) {
            answering.subscribe(topic("+/request"), Quality.AT_LEAST_ONCE, request -> {
                arrived.add(request);
                answering.publish(request.answer(new byte[] {-1, 0, 1}, "image/jpeg"));
            });
            asking.subscribe(topic("replies"), Quality.AT_LEAST_ONCE, arrived::add);
            asking.publish(message(topic("1/request"), "{\"do\":\"hold\"}")
                    .expiringAfter(30)
                    .answeredAt(topic("replies"), new byte[] {1, -2}));
            BrokerMessage request = next();
            assertThat(request.topic()).isEqualTo(topic("1/request"));
            assertThat(request.quality()).isEqualTo(Quality.AT_LEAST_ONCE);
            assertThat(request.retained()).isFalse();
            assertThat(request.contentType()).isEqualTo(BrokerMessage.JSON);
            assertThat(request.expirySeconds()).isBetween(1, 30);
            assertThat(request.text()).isEqualTo("{\"do\":\"hold\"}");
            BrokerMessage reply = next();
            assertThat(reply.payload()).containsExactly(-1, 0, 1);
            assertThat(reply.correlation()).containsExactly(1, -2);
            assertThat(reply.contentType()).isEqualTo("image/jpeg");
        }
    }

    @Test
    void aRetainedMessageIsThereForLaterSubscribersUntilItIsRemoved() throws Exception {
        try (BrokerConnection first = connected("first", null);
                BrokerConnection later = connected("later", null)) {
            first.publish(message(topic("kept"), "1").retain());
            first.publish(message(topic("removed"), "2").retain());
            first.publish(BrokerMessage.removing(topic("removed")));
            acknowledged(first, message(topic("last"), "3").retain());
            later.subscribe(topic("#"), Quality.AT_LEAST_ONCE, arrived::add);

            assertThat(List.of(next(), next()))
                    .allMatch(BrokerMessage::retained)
                    .extracting(BrokerMessage::text)
                    .containsExactlyInAnyOrder("1", "3");
            later.publish(message(topic("end"), "4"));
            assertThat(next().text()).isEqualTo("4");
            first.publish(BrokerMessage.removing(topic("kept")));
            acknowledged(first, BrokerMessage.removing(topic("last")));
        }
    }

    private static void acknowledged(BrokerConnection connection, BrokerMessage message) throws Exception {
        CompletableFuture<String> outcome = new CompletableFuture<>();
        connection.publish(
                message, problem -> outcome.complete(problem == null ? "acknowledged" : problem.getMessage()));
        assertThat(outcome.get(WaitLimit.SECONDS, TimeUnit.SECONDS)).isEqualTo("acknowledged");
    }

    @Test
    @SuppressWarnings("try")
    void theWillIsPublishedWhenAConnectionBreaksAndNotWhenItIsClosed() throws Exception {
        try (BrokerConnection watching = connected("watching", null);
                BrokerConnection breaking = connected("breaking", message(topic("will"), "broken"))) {
            BrokerConnection closing = connected("closing", message(topic("will"), "not closed"));
            watching.subscribe(topic("will"), Quality.AT_LEAST_ONCE, arrived::add);
            closing.publish(message(topic("will"), "closing"));
            closing.close();
            assertThat(next().text()).isEqualTo("closing");
            cut(breaking);

            assertThat(next().text()).isEqualTo("broken");
        }
    }

    @Test
    void aLostConnectionIsReportedAndMadeAgainWithItsSubscriptions() throws Exception {
        BlockingQueue<String> events = new LinkedBlockingQueue<>();
        try (BrokerConnection other = connected("other", null);
                BrokerConnection lost = connected("lost", null)) {
            lost.subscribe(topic("news"), Quality.AT_LEAST_ONCE, arrived::add);
            lost.subscribeUrgently(topic("urgent"), Quality.AT_LEAST_ONCE, arrived::add);
            lost.watch(recording(events));
            assertThat(events.poll(WaitLimit.SECONDS, TimeUnit.SECONDS)).isEqualTo(ONLINE);
            cut(lost);
            assertThat(events.poll(WaitLimit.SECONDS, TimeUnit.SECONDS)).startsWith("lost: ");
            assertThat(lost.isConnected()).isFalse();
            assertThatThrownBy(() -> lost.publish(message(topic("news"), "while lost")))
                    .isInstanceOf(BotException.class)
                    .hasMessageStartingWith("not connected");
            acknowledged(other, message(topic("news"), "missed"));
            restore(lost);
            assertThat(events.poll(WaitLimit.SECONDS, TimeUnit.SECONDS)).isEqualTo(ONLINE);
            acknowledged(lost, message(topic("news"), "after"));

            assertThat(next().text()).isEqualTo("after");
            acknowledged(lost, message(topic("urgent"), "urgent"));
            assertThat(next().text()).isEqualTo("urgent");
        }
    }

    private static BrokerConnection.Watcher recording(BlockingQueue<String> events) {
        return new BrokerConnection.Watcher() {
            @Override
            public void connected() {
                events.add(ONLINE);
            }

            @Override
            public void lost(String reason) {
                events.add("lost: " + reason);
            }
        };
    }

    @Test
    void messagesArriveInTheirOrder() {
        try (BrokerConnection sending = connected("sending", null);
                BrokerConnection receiving = connected("receiving", null)) {
            receiving.subscribe(topic("order"), Quality.AT_LEAST_ONCE, arrived::add);
            for (int i = 0; i < 300; i++) {
                sending.publish(message(topic("order"), Integer.toString(i)));
            }

            for (int i = 0; i < 300; i++) {
                assertThat(next().text()).isEqualTo(Integer.toString(i));
            }
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void anEndedSubscriptionGetsNothing() throws Exception {
        try (BrokerConnection one = connected("one", null)) {
            one.subscribe(topic("a"), Quality.AT_LEAST_ONCE, arrived::add);
            one.subscribe(topic("b"), Quality.AT_LEAST_ONCE, arrived::add);
            one.subscribeUrgently(topic("urgent"), Quality.AT_LEAST_ONCE, arrived::add);
            one.unsubscribe(topic("a"));
            one.unsubscribe(topic("urgent"));
            one.publish(message(topic("a"), "a"));
            one.publish(message(topic("urgent"), "urgent"));
            one.publish(message(topic("b"), "b"));

            assertThat(next().text()).isEqualTo("b");
        }
    }

    @Test
    void aClosedConnectionRefusesMessages() {
        BrokerConnection one = connected("one", null);
        one.close();

        assertThat(one.isConnected()).isFalse();
        assertThatThrownBy(() -> one.publish(message(topic("a"), "a"))).isInstanceOf(BotException.class);
    }
}
