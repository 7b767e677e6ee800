package majic.program;

import java.util.List;
import majic.bot.BotType;
import majic.gui.kit.RobotSharing;
import majic.shared.SharedType;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.MessageLimit;
import majic.shared.desk.SiteLatch;
import majic.shared.message.Sender;
import majic.team.Team;

/**
 * One site of which a program uses robots, or has used some: its team obeys the STOP of the site, and messages say when
 * the connection that STOP needs is lost and when it is back, also if the team has no robot there any more.
 * Thread-safe.
 */
final class UsedSite implements BrokerConnection.Watcher, AutoCloseable {
    private static final int MALFORMED_PER_S = 1;

    private final Team team;
    private final BrokerAddress address;
    private final SiteLatch latch;
    private final MessageLimit malformed;
    private volatile boolean lost;
    private volatile boolean closed;

    /**
     * Joins a team to the STOP of each site as soon as a robot of the site is used.
     *
     * @param types the types of robots, among them perhaps that of shared robots
     * @param sharing has the names under which this program sends
     */
    static void joinAll(Team team, List<BotType> types, ProgramSharing sharing) {
        for (BotType type : types) {
            if (type instanceof SharedType shared) {
                shared.sendAs(() -> sender(sharing));
                shared.observeSites((connection, address, by) -> new UsedSite(team, connection, address, by));
            }
        }
    }

    /** Leaves the sites, once the robots are closed. Takes at most 0.5 s for each broker. */
    static void leaveAll(List<BotType> types) {
        for (BotType type : types) {
            if (type instanceof SharedType shared) {
                shared.leaveSites();
            }
        }
    }

    private static Sender sender(ProgramSharing sharing) {
        RobotSharing.Place place = sharing.now().orElseGet(sharing::suggested);
        return Sender.ofThisRun(place.desk(), place.person());
    }

    /**
     * Joins the team to the STOP of the site.
     *
     * @param connection an open connection, which stays open
     * @throws majic.bot.BotException if the broker refuses the subscription
     */
    UsedSite(Team team, BrokerConnection connection, BrokerAddress address, Sender sender) {
        this.team = team;
        this.address = address;
        this.malformed = new MessageLimit(connection.time(), MALFORMED_PER_S);
        this.latch = new SiteLatch(team, connection, address.site(), sender);
        connection.watch(this);
    }

    @Override
    public void lost(String reason) {
        if (!closed) {
            lost = true;
            team.notice("the connection with the broker " + address.hostAndPort() + " is lost (" + reason
                    + "): until it is back, STOP of the site " + address.site() + " does not reach this desk");
        }
    }

    @Override
    public void connected() {
        if (!closed && lost) {
            lost = false;
            team.notice("connected with the broker " + address.hostAndPort() + " again: STOP of the site "
                    + address.site() + " reaches this desk");
        }
    }

    @Override
    public void malformed(String topic, String problem) {
        if (isOfSite(topic) && malformed.allows()) {
            long before = malformed.countToReport();
            team.notice("a message on " + topic + " is left out: " + problem
                    + (before == 0 ? "" : " (and " + before + " more malformed messages)"));
        }
    }

    @Override
    public void notSubscribed(String filter, String reason) {
        if (isOfSite(filter)) {
            team.notice("the broker " + address.hostAndPort() + " refuses the subscription to " + filter + " (" + reason
                    + "): nothing arrives from there");
        }
    }

    private boolean isOfSite(String topic) {
        return !closed && topic.startsWith(address.site() + "/");
    }

    @Override
    public void close() {
        closed = true;
        latch.close();
    }
}
