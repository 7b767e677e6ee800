package majic.shared.broker;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import com.hivemq.client.mqtt.mqtt5.message.connect.Mqtt5Connect;
import com.hivemq.client.mqtt.mqtt5.message.connect.Mqtt5ConnectBuilder;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import io.reactivex.disposables.Disposable;
import io.reactivex.schedulers.Schedulers;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.link.TcpConnector;
import org.jspecify.annotations.Nullable;

/**
 * One session of the client library with a broker, from the packet CONNECT to its end. It begins without a state and
 * ends with its TCP connection, so neither side keeps a message for a later session.
 */
final class HiveSession {
    /** Queued messages that arrive, of both qualities; the library drops further ones of quality of service 0. */
    private static final int RECEIVE_MAXIMUM = 500;

    private static final int LARGEST_PACKET_BYTES = 1 << 20;
    private static final int REACH_MS = 2_000;
    private static final long REPORT_MS = 500;

    private final Mqtt5AsyncClient client;
    private final OutgoingQueue outgoing = new OutgoingQueue();
    private volatile boolean accepted;

    /** What the messages of a session are for. */
    interface Arrivals {
        /**
         * Returns whether a topic has handlers. Called on the thread of the network.
         *
         * @param urgent true for those that have to be called at once, false for the others
         */
        boolean hasHandler(String topic, boolean urgent);

        /**
         * Calls the handlers of a message.
         *
         * @param urgent true for the urgent ones, on the thread of the network; false for the others, on the executor
         */
        void received(BrokerMessage message, boolean urgent);

        /** Reports a message that was left out, on the thread of the network. */
        void malformed(String topic, String problem);
    }

    private HiveSession(Mqtt5ClientBuilder builder, Consumer<Throwable> lost) {
        client = builder.addDisconnectedListener(context -> {
                    if (accepted) {
                        accepted = false;
                        outgoing.end(context.getCause());
                        lost.accept(context.getCause());
                    }
                })
                .buildAsync();
    }

    /**
     * Connects to a broker. Blocks for the timeout and 2.5 s at most, with the usual timeout for 8 s.
     *
     * @param handlers runs the handlers that are not urgent
     * @param arrivals receives each message
     * @param lost called once when an accepted session ends otherwise than by {@link #disconnect}
     * @throws ConnectFailed with the reason and advice
     */
    static HiveSession open(
            BrokerAddress address,
            ConnectOptions options,
            Executor handlers,
            Arrivals arrivals,
            Consumer<Throwable> lost) {
        BrokerCredentials credentials =
                BrokerCredentials.find(address, options.environment().settings());
        InetAddress computer = reach(address);
        Mqtt5ClientBuilder builder = Mqtt5Client.builder()
                .identifier(options.clientId())
                .executorConfig(HiveThreads.config())
                .transportConfig()
                .serverAddress(new InetSocketAddress(computer, address.port()))
                .socketConnectTimeout(options.timeoutMs(), TimeUnit.MILLISECONDS)
                .mqttConnectTimeout(options.timeoutMs(), TimeUnit.MILLISECONDS)
                .sslConfig(address.secure() ? HiveTls.config(credentials) : null)
                .applyTransportConfig();
        HiveSession session = new HiveSession(builder, lost);
        session.receive(arrivals, handlers);
        session.connect(address, connect(options, credentials), options.timeoutMs() + REPORT_MS);
        MalformedMessages.leaveOut(session.client, arrivals::malformed);
        return session;
    }

    /**
     * Looks the broker's computer up and tries its port, to report what fails in the same words as for robots.
     *
     * @return the computer's address with the name under which its certificate has to be issued
     * @throws ConnectFailed if it cannot be reached; the message has the reason and advice
     */
    private static InetAddress reach(BrokerAddress address) {
        String host = address.host().replaceAll("[\\[\\]]", "");
        try (Socket socket = new Socket()) {
            new TcpConnector(host, address.port()).connect(socket, REACH_MS);
            return InetAddress.getByAddress(host, socket.getInetAddress().getAddress());
        } catch (IOException e) {
            throw ConnectFailed.of(e, address + ": " + e.getMessage());
        }
    }

    private void receive(Arrivals arrivals, Executor handlers) {
        Consumer<Mqtt5Publish> urgent = publish -> {
            if (arrivals.hasHandler(publish.getTopic().toString(), true)) {
                arrivals.received(HiveMessages.received(publish), true);
            }
        };
        client.publishes(MqttGlobalPublishFilter.ALL, urgent);
        receiveOthers(arrivals, handlers);
    }

    /**
     * What only urgent handlers need does not wake the thread of the others. The end of the session ends the flow with
     * an error.
     */
    private void receiveOthers(Arrivals arrivals, Executor handlers) {
        Disposable ignored = client.toRx()
                .publishes(MqttGlobalPublishFilter.ALL)
                .filter(publish -> arrivals.hasHandler(publish.getTopic().toString(), false))
                .observeOn(Schedulers.from(handlers), true)
                .subscribe(publish -> arrivals.received(HiveMessages.received(publish), false), ended -> {});
    }

    private static Mqtt5Connect connect(ConnectOptions options, BrokerCredentials credentials) {
        Mqtt5ConnectBuilder connect = Mqtt5Connect.builder()
                .cleanStart(true)
                .sessionExpiryInterval(0)
                .keepAlive(options.keepAliveSeconds())
                .restrictions()
                .receiveMaximum(RECEIVE_MAXIMUM)
                .maximumPacketSize(LARGEST_PACKET_BYTES)
                .applyRestrictions();
        BrokerMessage will = options.will();
        if (will != null) {
            connect = connect.willPublish(HiveMessages.will(will));
        }
        return credentials.login().map(connect::simpleAuth).orElse(connect).build();
    }

    private void connect(BrokerAddress address, Mqtt5Connect packet, long timeoutMs) {
        CompletableFuture<?> answer = client.connect(packet);
        try {
            answer.get(timeoutMs, TimeUnit.MILLISECONDS);
            outgoing.begin(client.toRx());
            accepted = true;
        } catch (ExecutionException e) {
            throw HiveErrors.connectFailed(address, e.getCause());
        } catch (TimeoutException e) {
            answer.cancel(true);
            client.disconnect();
            throw HiveErrors.noAnswer(address, e);
        } catch (InterruptedException e) {
            answer.cancel(true);
            client.disconnect();
            Thread.currentThread().interrupt();
            throw new ConnectFailed(Reason.OTHER, "interrupted while connecting to " + address, e);
        }
    }

    /** Returns whether the broker has accepted this client and the connection exists. */
    boolean isOpen() {
        return accepted && client.getState().isConnected();
    }

    /** Sends a subscription; completed when the broker has acknowledged it. */
    CompletableFuture<?> subscribe(String filter, Quality quality) {
        return client.subscribeWith()
                .topicFilter(filter)
                .qos(HiveMessages.quality(quality))
                .send();
    }

    /** Ends a subscription. */
    void unsubscribe(String filter) {
        client.unsubscribeWith().topicFilter(filter).send();
    }

    /**
     * Queues a message.
     *
     * @param outcome called once: with null when it is acknowledged or written, otherwise with the reason
     * @throws BotException if the session has ended or is too slow
     */
    void publish(BrokerMessage message, Consumer<@Nullable Throwable> outcome) {
        outgoing.add(message, outcome);
    }

    /** Ends the session after what was queued; the broker does not publish the will. */
    CompletableFuture<?> disconnect() {
        accepted = false;
        return client.disconnect()
                .whenComplete((done, failure) -> outgoing.end(new BotException("the connection was closed")));
    }
}
