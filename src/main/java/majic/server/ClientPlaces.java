package majic.server;

import java.net.InetAddress;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * The clients of a server. Clients that were not admitted yet have places of their own, so that a stranger takes none
 * from the programs that have the token; and an address that floods loses its own connections first. Changed on the
 * server's thread; read on any.
 */
final class ClientPlaces {
    /** Maximum number of admitted clients. */
    static final int MOST_CLIENTS = 64;

    /** Maximum number of clients that have not sent their first line yet. */
    static final int MOST_STRANGERS = 128;

    /** Time without a line after which a client has to make room for another one. */
    static final int IDLE_MINUTES = 10;

    private static final long IDLE_NANOS = IDLE_MINUTES * 60_000_000_000L;

    /** In the order in which they connected. */
    private final List<LineClient> clients = new CopyOnWriteArrayList<>();

    void forEach(Consumer<LineClient> task) {
        clients.forEach(task);
    }

    /** Gives each client a turn; returns whether one of them has more to do at once. */
    boolean work() {
        boolean more = false;
        for (LineClient client : clients) {
            more |= client.work();
        }
        return more;
    }

    boolean isAnyWaiting() {
        return clients.stream().anyMatch(LineClient::isWaiting);
    }

    void removeGone() {
        clients.removeIf(LineClient::isGone);
    }

    /** Adds a client that has sent nothing yet; if there are too many of these, the oldest of one address is closed. */
    void add(LineClient client) {
        removeGone();
        clients.add(client);
        Map<InetAddress, List<LineClient>> strangers =
                clients.stream().filter(each -> !each.isAdmitted()).collect(Collectors.groupingBy(LineClient::address));
        if (strangers.values().stream().mapToInt(List::size).sum() > MOST_STRANGERS) {
            strangers.values().stream()
                    .max(Comparator.comparingInt(List::size))
                    .ifPresent(most -> most.get(0).close());
        }
    }

    /**
     * Finds a place for a client that may command the team: a free one, that of a client that sends no more lines, or
     * that of the one without a line for the longest time.
     *
     * @return false if there is none
     */
    boolean makeRoom() {
        List<LineClient> admitted =
                clients.stream().filter(LineClient::hasPlace).toList();
        return admitted.size() < MOST_CLIENTS
                || dropLongestIdle(
                        admitted.stream().filter(LineClient::hasEnded).toList(), LineClient::close)
                || dropLongestIdle(
                        admitted.stream()
                                .filter(client -> client.idleNanos() > IDLE_NANOS)
                                .toList(),
                        client -> client.dismiss("closed: no line came for " + IDLE_MINUTES
                                + " minutes, and another program needs the place"));
    }

    private static boolean dropLongestIdle(List<LineClient> some, Consumer<LineClient> drop) {
        some.stream().max(Comparator.comparingLong(LineClient::idleNanos)).ifPresent(drop);
        return !some.isEmpty();
    }
}
