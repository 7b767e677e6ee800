package majic.ros.graph;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * Finds the robots that can be driven: topics of velocity commands, grouped by the namespace of the robot, each with
 * the odometry of that namespace. A command topic that no node receives belongs to no robot. Used by one thread.
 */
public final class BaseFinder {
    /** So many command topics are checked for receivers; a system with more is searched by name alone. */
    private static final int MOST_CHECKED = 24;

    private final RosGraph graph;
    private final Function<String, Optional<List<String>>> subscribers;
    private @Nullable List<Base> found;

    /**
     * Creates a search.
     *
     * @param graph the topics
     * @param subscribers the nodes that receive a topic, without the rosbridge server; empty if that is not known
     */
    public BaseFinder(RosGraph graph, Function<String, Optional<List<String>>> subscribers) {
        this.graph = graph;
        this.subscribers = subscribers;
    }

    /** A topic of velocity commands. */
    private record Command(String namespace, String topic, String type) {
        int rank() {
            return TopicNames.commandRank(TopicNames.relative(topic, namespace));
        }
    }

    /**
     * Finds all robots; asks for the receivers of topics the first time only.
     *
     * @return by namespace, in alphabetical order
     */
    public List<Base> all() {
        List<Base> known = found;
        if (known == null) {
            known = search();
            found = known;
        }
        return known;
    }

    private List<Base> search() {
        Map<String, List<Command>> byNamespace = new TreeMap<>();
        for (Command command : received(commands())) {
            byNamespace
                    .computeIfAbsent(command.namespace(), namespace -> new ArrayList<>())
                    .add(command);
        }
        return byNamespace.values().stream().map(this::base).toList();
    }

    /**
     * Finds the robots that an address means.
     *
     * @param namespace as in the address; empty if it has none
     * @param name a namespace, or the topic of odometry or of commands; null if the address has none
     * @return none, one or several
     */
    public List<Base> matching(String namespace, @Nullable String name) {
        List<Base> inNamespace = all().stream()
                .filter(base -> namespace.isEmpty()
                        || base.namespace().equals(namespace)
                        || base.namespace().startsWith(namespace + "/"))
                .toList();
        if (name == null) {
            return inNamespace;
        }
        List<Base> named =
                inNamespace.stream().filter(base -> base.isNamed(name)).toList();
        return named.isEmpty() ? byTopic(name) : named;
    }

    /** A topic that the search would not have chosen for its robot. */
    private List<Base> byTopic(String name) {
        String topic = name.startsWith("/") ? name : "/" + name;
        String namespace = TopicNames.namespace(topic);
        String type = Objects.requireNonNullElse(graph.typeOf(topic), "");
        if (type.equals(Base.TWIST) || type.equals(Base.TWIST_STAMPED)) {
            return List.of(base(List.of(new Command(namespace, topic, type))));
        }
        return type.equals(Base.ODOMETRY)
                ? all().stream()
                        .filter(base -> base.namespace().equals(namespace))
                        .map(base -> new Base(namespace, base.command(), base.commandType(), topic))
                        .toList()
                : List.of();
    }

    private List<Command> commands() {
        List<Command> commands = new ArrayList<>();
        for (String type : List.of(Base.TWIST, Base.TWIST_STAMPED)) {
            graph.topicsOf(type).forEach(topic -> commands.add(new Command(TopicNames.namespace(topic), topic, type)));
        }
        return commands;
    }

    private List<Command> received(List<Command> commands) {
        return commands.size() > MOST_CHECKED
                ? commands
                : commands.stream()
                        .filter(command -> subscribers
                                .apply(command.topic())
                                .map(nodes -> !nodes.isEmpty())
                                .orElse(true))
                        .toList();
    }

    private Base base(List<Command> commands) {
        Command best = commands.stream()
                .min(Comparator.comparingInt(Command::rank).thenComparing(Command::topic))
                .orElseThrow();
        return new Base(best.namespace(), best.topic(), best.type(), odometry(best.namespace()));
    }

    private @Nullable String odometry(String namespace) {
        return graph.topicsOf(Base.ODOMETRY).stream()
                .filter(topic -> TopicNames.namespace(topic).equals(namespace))
                .min(Comparator.<String>comparingInt(
                                topic -> TopicNames.odometryRank(TopicNames.relative(topic, namespace)))
                        .thenComparing(Comparator.naturalOrder()))
                .orElse(null);
    }
}
