package majic.ros.graph;

import java.util.List;
import java.util.stream.Collectors;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import org.jspecify.annotations.Nullable;

/** Chooses the robot that an address means, and explains why there is none or more than one. */
public final class BaseChoice {
    private static final int MOST_LISTED = 10;

    private final RosGraph graph;
    private final BaseFinder finder;
    private final String server;

    /**
     * Creates a choice.
     *
     * @param graph the topics
     * @param finder finds the robots
     * @param server the address of the server, as {@code ros://host:9090}
     */
    public BaseChoice(RosGraph graph, BaseFinder finder, String server) {
        this.graph = graph;
        this.finder = finder;
        this.server = server;
    }

    /**
     * Chooses.
     *
     * @param namespace as in the address; empty if it has none
     * @param name a namespace or a topic; null if the address has none
     * @return the robot
     * @throws ConnectFailed if there is none, or more than one; the message lists the addresses
     */
    public Base choose(String namespace, @Nullable String name) {
        List<Base> matching = finder.matching(namespace, name);
        if (matching.size() == 1) {
            return matching.get(0);
        }
        List<Base> others = matching.isEmpty() ? finder.all() : matching;
        if (others.isEmpty()) {
            throw new ConnectFailed(Reason.WRONG_DEVICE, noBase());
        }
        if (matching.isEmpty()) {
            throw new ConnectFailed(
                    Reason.WRONG_DEVICE,
                    "there is no robot " + (name == null ? namespace : name) + " behind " + server + "; is it "
                            + addresses(others) + "?");
        }
        throw new ConnectFailed(
                Reason.OTHER,
                "there are " + others.size() + " robots behind " + server + "; is it " + addresses(others) + "?");
    }

    /**
     * Returns the robots that were not chosen.
     *
     * @param chosen by {@link #choose}
     * @return the others behind the server
     */
    public OtherRobots besides(Base chosen) {
        return OtherRobots.besides(chosen, finder.all());
    }

    private String noBase() {
        List<String> unread = graph.topicsOf(Base.TWIST);
        String there = unread.isEmpty() ? "" : "; no node receives " + unread.get(0);
        return "no robot that can be driven is behind " + server + ", which runs " + graph.title() + " with "
                + graph.topics().size() + " topics: none of the type " + graph.typeName(Base.TWIST)
                + " or TwistStamped is received by a node" + there + "; do the robot's own nodes (bringup) run?";
    }

    private String addresses(List<Base> bases) {
        String listed = bases.stream()
                .limit(MOST_LISTED)
                .map(base -> server + base.inAddress())
                .collect(Collectors.joining(" or "));
        return bases.size() > MOST_LISTED ? listed + " or " + (bases.size() - MOST_LISTED) + " others" : listed;
    }
}
