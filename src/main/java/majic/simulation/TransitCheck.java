package majic.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import majic.link.Traffic;
import majicsim.net.LineCount;

/**
 * Determines whether no byte is in transit between the drivers and the robots of one lab: every byte that either end
 * wrote has been processed at the other. Used by one thread.
 *
 * <p>Counts only grow, so two equal readings in succession mean that nothing was transferred between them. A stepped
 * clock checks this before each of its steps, so it is written without streams, which take most of the time for so few
 * lines.
 */
public final class TransitCheck implements BooleanSupplier {
    private final Supplier<List<Traffic>> drivers;
    private final Supplier<List<LineCount>> robots;
    private final Set<String> robotAddresses;
    private final Set<Ends> met = new HashSet<>();

    /**
     * Addresses of both ends of a connection. One alone does not identify it: a system may use the same local port for
     * connections to several robots.
     */
    private record Ends(String driver, String robot) {
        static Ends of(Traffic link) {
            return new Ends(link.local(), link.remote());
        }

        static Ends of(LineCount line) {
            return new Ends(line.peer(), line.robot());
        }
    }

    /**
     * Creates a comparison of both ends.
     *
     * @param drivers the traffic of all connections of this program
     * @param robots the lines of this lab
     * @param robotAddresses where this lab's robots listen, so that connections to others do not count
     */
    public TransitCheck(Supplier<List<Traffic>> drivers, Supplier<List<LineCount>> robots, Set<String> robotAddresses) {
        this.drivers = drivers;
        this.robots = robots;
        this.robotAddresses = robotAddresses;
    }

    @Override
    public boolean getAsBoolean() {
        List<Traffic> links = ours();
        List<LineCount> lines = robots.get();
        return agree(links, lines) && links.equals(ours()) && lines.equals(robots.get());
    }

    /** Lists the counts of both ends, connection by connection, for a report on a clock that does not advance. */
    @Override
    public String toString() {
        return "drivers " + ours() + ", robots " + robots.get();
    }

    private List<Traffic> ours() {
        List<Traffic> ours = new ArrayList<>();
        for (Traffic link : drivers.get()) {
            if (robotAddresses.contains(link.remote())) {
                ours.add(link);
            }
        }
        return ours;
    }

    private boolean agree(List<Traffic> links, List<LineCount> lines) {
        Map<Ends, LineCount> left = new HashMap<>();
        for (LineCount line : lines) {
            left.put(Ends.of(line), line);
        }
        met.retainAll(left.keySet());
        for (Traffic link : links) {
            met.add(Ends.of(link));
            LineCount line = left.remove(Ends.of(link));
            if (line == null || !agree(link, line)) {
                return false;
            }
        }
        for (Map.Entry<Ends, LineCount> line : left.entrySet()) {
            if (met.contains(line.getKey())
                    && line.getValue().open()
                    && !line.getValue().unread()) {
                return false;
            }
        }
        return true;
    }

    private static boolean agree(Traffic link, LineCount line) {
        return line.open() && link.consumed() == line.written() && (line.unread() || line.consumed() == link.written());
    }
}
