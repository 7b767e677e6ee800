package majic.ros.graph;

import java.util.List;

/**
 * The namespaces of the robots behind a server that are not the chosen one. What is in them belongs to these robots,
 * also if the chosen one has no namespace. Immutable.
 *
 * @param namespaces as {@code /robot2}
 */
public record OtherRobots(List<String> namespaces) {
    /** Keeps a copy. */
    public OtherRobots {
        namespaces = List.copyOf(namespaces);
    }

    /**
     * Returns the robots besides a chosen one.
     *
     * @param chosen its base
     * @param all the bases behind the server
     * @return without the namespaces that the chosen one is in
     */
    static OtherRobots besides(Base chosen, List<Base> all) {
        String own = chosen.namespace() + "/";
        return new OtherRobots(all.stream()
                .map(Base::namespace)
                .filter(namespace -> !own.startsWith(namespace + "/"))
                .toList());
    }

    /**
     * Returns whether a topic or action belongs to one of these robots.
     *
     * @param name absolute
     * @return false for what is the chosen robot's, or no robot's
     */
    public boolean have(String name) {
        return namespaces.stream().anyMatch(namespace -> name.startsWith(namespace + "/"));
    }
}
