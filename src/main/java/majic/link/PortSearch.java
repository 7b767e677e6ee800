package majic.link;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;

/**
 * Finds the hosts of a network that accept TCP connections at given ports. Each connection is closed as soon as it is
 * open; nothing is sent. Thread-safe.
 */
public final class PortSearch implements AutoCloseable {
    private static final int THREADS = 32;
    private static final int CONNECT_MS = 500;

    private final List<InetSocketAddress> places;
    private final Listener listener;
    private final AtomicInteger done = new AtomicInteger();
    private final ExecutorService threads =
            Executors.newFixedThreadPool(THREADS, body -> daemon(body, "search for robots"));
    private volatile boolean closed;

    /** Receives the results, on threads of the search. */
    public interface Listener {
        /**
         * A host accepts connections at a port.
         *
         * @param place the host by number, and the port
         */
        void found(InetSocketAddress place);

        /**
         * A further place was tried; not called after {@link PortSearch#close}.
         *
         * @param tried how many were tried so far; the search has ended when it is {@code all}
         * @param all how many there are
         */
        void progress(int tried, int all);
    }

    /**
     * Creates a search; {@link #start} starts it.
     *
     * @param hosts the hosts to try, by number
     * @param ports the ports to try on each
     * @param spared places that are not tried, because a robot of the team is connected there
     * @param listener receives the results
     */
    public PortSearch(
            Collection<InetAddress> hosts,
            Collection<Integer> ports,
            Set<InetSocketAddress> spared,
            Listener listener) {
        this.places = hosts.stream()
                .flatMap(host -> ports.stream().map(port -> new InetSocketAddress(host, port)))
                .filter(place -> !spared.contains(place))
                .toList();
        this.listener = listener;
    }

    /** Starts the search; returns at once. */
    public void start() {
        if (places.isEmpty()) {
            listener.progress(0, 0);
        }
        places.forEach(place -> threads.execute(() -> look(place)));
        threads.shutdown();
    }

    private void look(InetSocketAddress place) {
        if (closed) {
            return;
        }
        boolean answers = accepts(place);
        if (closed) {
            return;
        }
        if (answers) {
            listener.found(place);
        }
        listener.progress(done.incrementAndGet(), places.size());
    }

    private static boolean accepts(InetSocketAddress place) {
        try (Socket socket = new Socket()) {
            socket.connect(place, CONNECT_MS);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /** Ends the search; returns at once. */
    @Override
    public void close() {
        closed = true;
        threads.shutdownNow();
    }

    private static Thread daemon(Runnable body, String name) {
        Thread thread = new Thread(body, name);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Lists the other hosts that can be in the networks of this computer: of each network the 254 addresses that differ
     * from this computer's only in their last number. Blocks.
     *
     * @return the addresses, without this computer's; empty without a network
     */
    public static List<InetAddress> neighbours() {
        try {
            return NetworkInterface.networkInterfaces()
                    .filter(PortSearch::isUp)
                    .flatMap(network -> network.getInterfaceAddresses().stream())
                    .map(InterfaceAddress::getAddress)
                    .filter(Inet4Address.class::isInstance)
                    .map(own -> neighbours(own.getAddress()))
                    .distinct()
                    .flatMap(List::stream)
                    .toList();
        } catch (SocketException e) {
            return List.of();
        }
    }

    private static boolean isUp(NetworkInterface network) {
        try {
            return network.isUp() && !network.isLoopback();
        } catch (SocketException e) {
            return false;
        }
    }

    /** Lists the addresses that differ from one only in their last number. */
    static List<InetAddress> neighbours(byte[] own) {
        List<InetAddress> others = new ArrayList<>();
        IntStream.rangeClosed(1, 254).filter(last -> (byte) last != own[3]).forEach(last -> {
            byte[] other = own.clone();
            other[3] = (byte) last;
            others.add(address(other));
        });
        return others;
    }

    private static InetAddress address(byte[] number) {
        try {
            return InetAddress.getByAddress(number);
        } catch (UnknownHostException e) {
            throw new IllegalArgumentException("not four bytes", e);
        }
    }

    /**
     * Names networks for users.
     *
     * @param hosts addresses
     * @return for instance {@code 192.168.1.x}, each once
     */
    public static String networks(Collection<InetAddress> hosts) {
        Set<String> names = new TreeSet<>();
        hosts.forEach(host -> names.add(host.getHostAddress().replaceFirst("\\d+$", "x")));
        return String.join(", ", names);
    }
}
