package majic.shared.desk;

import java.util.Collection;
import java.util.Set;
import majic.bot.BotException;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.LatchMessage;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.UnusableMessageException;
import majic.team.Team;

/**
 * Joins a team to the STOP of a site: STOP at any desk of the site latches the team, and STOP of the team latches all
 * desks. A team may be joined to several sites, and to one of them over several connections. Stops of the team itself
 * are written before anything is published, and need no broker. Thread-safe.
 */
public final class SiteLatch implements AutoCloseable {
    /** If the broker delivers no kept STOP or release within this time, it has forgotten it, seconds. */
    private static final double RETAINED_S = 1;

    private final BrokerConnection connection;
    private final String topic;
    private final Sender sender;
    private final TeamLatch latch;
    private volatile long connections;
    private volatile long answeredConnection;
    private volatile boolean closed;

    /**
     * Joins the team to the site from now on. Blocks for at most 2 s if the connection exists already.
     *
     * @param team the robots of this program
     * @param connection with the broker, connected or not; stays open
     * @param site one or more levels with slashes between them
     * @param sender this desk, as others see it
     * @throws BotException if the broker refuses the subscription
     */
    public SiteLatch(Team team, BrokerConnection connection, String site, Sender sender) {
        this.connection = connection;
        this.topic = new SiteTopics(site).stop();
        this.sender = sender;
        this.latch = TeamLatch.join(team, this);
        try {
            connection.subscribe(topic, Quality.AT_LEAST_ONCE, this::received);
        } catch (BotException e) {
            latch.leave(this);
            throw e;
        }
        connection.watch(new BrokerConnection.Watcher() {
            @Override
            public void connected() {
                SiteLatch.this.connected();
            }
        });
    }

    Sender sender() {
        return sender;
    }

    BrokerConnection connection() {
        return connection;
    }

    private void connected() {
        if (closed) {
            return;
        }
        long now = ++connections;
        latch.publishUnpublished(this);
        connection.time().tryRunAsync("latch of the site", () -> repeatIfForgotten(now));
    }

    /** The broker delivers what it keeps right after the subscription. */
    private void repeatIfForgotten(long connected) {
        try {
            connection.time().sleep(RETAINED_S);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (!closed && connections == connected && answeredConnection != connected) {
            latch.repeat(this);
        }
    }

    /** A message that cannot be read counts as STOP. All desks of the site derive the same id from it. */
    private void received(BrokerMessage message) {
        answeredConnection = connections;
        if (message.payload().length == 0 || closed) {
            return;
        }
        try {
            latch.received(this, LatchMessage.parse(message.payload()));
        } catch (UnusableMessageException e) {
            String id = "unreadable-" + Integer.toHexString(message.text().hashCode());
            latch.receivedWithoutId(
                    this, new LatchMessage(true, id, Set.of(), "a message that cannot be read", "", null));
        }
    }

    boolean publishRelease(Collection<String> ids) {
        return publish(LatchMessage.release(ids, sender));
    }

    /** Returns false while there is no connection; a STOP is published with the next one then. */
    boolean publish(LatchMessage message) {
        try {
            connection.publish(BrokerMessage.json(topic, message.toJson(), Quality.AT_LEAST_ONCE)
                    .retain());
            return true;
        } catch (BotException e) {
            return false;
        }
    }

    /** Ends the membership; the connection stays open. A latch of the team stays. */
    @Override
    public void close() {
        closed = true;
        connection.unsubscribe(topic);
        latch.leave(this);
    }
}
