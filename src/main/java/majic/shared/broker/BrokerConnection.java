package majic.shared.broker;

import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A connection to an MQTT 5 broker. A lost connection is made again by itself until the connection is closed; nothing
 * that was published meanwhile is kept for later, and the broker keeps nothing for this client either. Watchers and all
 * handlers but those of {@link #subscribeUrgently} are called on one thread, in the order in which the broker sent.
 * Thread-safe.
 */
public interface BrokerConnection extends AutoCloseable {
    /**
     * Creates a connection, which is made by {@link #connect}.
     *
     * @param address of the broker
     * @param options name of this client, last will and keep alive
     * @return the connection; its threads are daemons and end with {@link #close}
     * @throws BotException if the library is missing; the message names it
     */
    static BrokerConnection open(BrokerAddress address, ConnectOptions options) {
        try {
            Class.forName(
                    "com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient", false, BrokerConnection.class.getClassLoader());
        } catch (ClassNotFoundException e) {
            throw new BotException("shared robots need the library hivemq-mqtt-client: add it to the class path", e);
        }
        return new HiveConnection(address, options);
    }

    /** Handles the messages of a subscription. */
    @FunctionalInterface
    interface Handler {
        /**
         * Handles one message. Runs on the only thread of the connection and must not wait: everything else that
         * arrives waits for it. What it throws is logged.
         *
         * @param message what arrived
         */
        void received(BrokerMessage message);
    }

    /** Receives changes of the connection, on the thread of the handlers, and must not wait either. */
    interface Watcher {
        /**
         * The broker has accepted this client, for the first time or again. Runs before the first message of this
         * connection is handled. All subscriptions have been sent before: the answer to a request published here
         * arrives.
         */
        default void connected() {}

        /**
         * The connection was lost. It is being made again.
         *
         * @param reason how, as half a sentence
         */
        default void lost(String reason) {}

        /**
         * The broker has refused a message that was published by {@link BrokerConnection#publish(BrokerMessage)}. For
         * quality of service 0 only the first message on each topic of a connection has an outcome.
         *
         * @param message what was not published
         * @param reason as the broker gives it: {@code not authorized}
         */
        default void notPublished(BrokerMessage message, String reason) {}

        /**
         * The broker has refused a subscription when the connection was made, so no message arrives for it.
         *
         * @param filter as it was subscribed to
         * @param reason as the broker gives it
         */
        default void notSubscribed(String filter, String reason) {}

        /**
         * The broker has delivered a message that breaks the rules of MQTT. It was left out: no handler is called.
         *
         * @param topic of the message, control characters made visible
         * @param problem what is wrong in it, as half a sentence
         */
        default void malformed(String topic, String problem) {}
    }

    /**
     * Connects. Blocks for at most 8 s. Returns at once if the connection was made before, even if it is lost at the
     * moment. May be called again after a failure.
     *
     * @throws ConnectFailed with the reason and advice; nothing stays open
     */
    void connect();

    /**
     * Registers a watcher. If the connection exists, its {@link Watcher#connected} is called soon.
     *
     * @param watcher called from now on
     */
    void watch(Watcher watcher);

    /**
     * Subscribes to topics, also after each reconnection. While connected, returns when the broker has acknowledged,
     * for which it waits at most 2 s, and must not be called by a handler or watcher then; otherwise the subscription
     * is made with the connection. Retained messages are delivered for each subscription, also after a reconnection. A
     * message that matches several filters is delivered to each of their handlers.
     *
     * @param filter a topic, in which {@code +} stands for one level and {@code #} at the end for all further levels
     * @param quality the highest quality of service of the delivery
     * @param handler handles the messages; replaces the handler of the same filter
     * @throws BotException if the broker refuses or does not acknowledge; the subscription is not made then
     */
    void subscribe(String filter, Quality quality, Handler handler);

    /**
     * Subscribes as {@link #subscribe}, to messages that must not wait for any others: commands for robots. The handler
     * is called on the thread that reads from all brokers, in the order in which the broker sent these messages, and
     * perhaps before {@link Watcher#connected}. Whatever that thread does delays all connections with brokers, so the
     * handler must neither wait nor compute for longer than a fraction of a millisecond.
     *
     * @param filter as {@link #subscribe}
     * @param quality as {@link #subscribe}
     * @param handler as {@link #subscribe}, on the other thread
     * @throws BotException as {@link #subscribe}
     */
    void subscribeUrgently(String filter, Quality quality, Handler handler);

    /**
     * Ends a subscription, if it exists; does not wait for the acknowledgement of the broker. No message is passed to
     * its handler any more, except for one that is being handled.
     *
     * @param filter as it was subscribed to
     */
    void unsubscribe(String filter);

    /**
     * Publishes a message: queues it to be written in the order of the calls, and never blocks. A refusal of the broker
     * is reported to the watchers. The first message on each topic of a connection is sent with quality of service 1,
     * since a broker refuses others silently.
     *
     * @param message what to publish
     * @throws BotException while not connected, or while so much waits to be sent that the network or the broker is too
     *     slow; the message is not kept for later
     */
    void publish(BrokerMessage message);

    /**
     * Publishes a message as {@link #publish(BrokerMessage)}, and reports its outcome to the caller alone.
     *
     * @param message what to publish
     * @param acknowledged called once: with null when the broker has acknowledged it (quality of service 1) or it has
     *     been written (0), with a {@link PublicationRefused} if the broker refuses it, otherwise with the reason; on
     *     any thread, must not wait
     * @throws BotException as {@link #publish(BrokerMessage)}; {@code acknowledged} is not called then
     */
    void publish(BrokerMessage message, Consumer<@Nullable BotException> acknowledged);

    /**
     * Returns whether messages can be published at the moment.
     *
     * @return false before {@link #connect}, after a loss until the reconnection, and after {@link #close}
     */
    boolean isConnected();

    /**
     * Returns the clock of the connection.
     *
     * @return the same object at each call
     */
    TimeSource time();

    /**
     * Ends the connection: sends what is queued, for which it waits at most 0.5 s, then disconnects so that the broker
     * does not publish the last will. No handler or watcher is called afterwards, except for one that is running.
     */
    @Override
    void close();
}
