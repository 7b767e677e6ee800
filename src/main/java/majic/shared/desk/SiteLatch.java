package majic.shared.desk;

import java.util.Set;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.PublicationRefused;
import majic.shared.broker.Quality;
import majic.shared.message.LatchMessage;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.UnusableMessageException;
import majic.team.Team;
import org.jspecify.annotations.Nullable;

/**
 * Joins a team to the STOP of a site: STOP at any desk of the site latches the team, and STOP of the team latches all
 * desks. A team may be joined to several sites, and to one of them over several connections. Stops of the team itself
 * are written before anything is published, and need no broker. Thread-safe.
 */
public final class SiteLatch implements AutoCloseable {
    /** If the broker delivers no kept STOP or release within this time, it has forgotten it, seconds. */
    private static final double RETAINED_S = 1;

    private final BrokerConnection connection;
    private final Team team;
    private final String site;
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
        this.team = team;
        this.connection = connection;
        this.site = site;
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

            @Override
            public void malformed(String where, String problem) {
                if (where.equals(topic)) {
                    unreadable(problem, "a malformed message");
                }
            }

            @Override
            public void notSubscribed(String filter, String reason) {
                if (filter.equals(topic)) {
                    team.notice("STOP of other desks of the site " + site + " does not reach this desk: the broker"
                            + " refuses the subscription to " + topic + " (" + reason + ")");
                }
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
            unreadable(message.text(), "a message that cannot be read");
        }
    }

    private void unreadable(String content, String what) {
        answeredConnection = connections;
        if (!closed) {
            String id = "unreadable-" + Integer.toHexString(content.hashCode());
            latch.receivedWithoutId(this, new LatchMessage(true, id, Set.of(), what, "", null));
        }
    }

    /**
     * Publishes a STOP or a release.
     *
     * @param outcome called with null when the broker has taken it, otherwise with the reason; must not wait
     * @return false while there is no connection; a STOP is published with the next one then
     */
    boolean publish(LatchMessage message, Consumer<@Nullable BotException> outcome) {
        try {
            connection.publish(
                    BrokerMessage.json(topic, message.toJson(), Quality.AT_LEAST_ONCE)
                            .retain(),
                    outcome);
            return true;
        } catch (BotException e) {
            return false;
        }
    }

    /** Returns what a refused STOP means. */
    String stopRefused(PublicationRefused refused) {
        return "STOP has stopped only the robots of this program: the broker refuses it on " + topic + " ("
                + refused.reason() + "), so other robots of the site " + site
                + " go on; stop them at a desk whose user may write there, or switch them off";
    }

    /** Returns what a STOP without a connection means. */
    String stopWaits() {
        return "STOP has stopped only the robots of this program: there is no connection with the broker; it stops the"
                + " other robots of the site " + site + " when the connection is back";
    }

    /** Returns what a release that the broker has not taken means. */
    String releaseRefused(BotException problem) {
        return problem instanceof PublicationRefused refused
                ? "not released: the broker refuses it on " + topic + " (" + refused.reason() + "), so the site " + site
                        + " stays stopped; a user who may write there can release it"
                : "not released: " + problem.getMessage() + "; release again when the connection is back";
    }

    /** Returns what a release without a connection means. */
    String releasedApart() {
        return "released only here: there is no connection with the broker; if the STOP of the site " + site
                + " is not released when the connection is back, it stops this desk again";
    }

    /** Ends the membership; the connection stays open. A latch of the team stays. */
    @Override
    public void close() {
        closed = true;
        connection.unsubscribe(topic);
        latch.leave(this);
    }
}
