package majic.shared;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import majic.bot.ConnectFailed;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;
import majic.shared.message.Sender;

/** The connections of a program to brokers: one for each broker, open while a shared robot uses it. Thread-safe. */
final class BrokerPool {
    private static final Logger LOG = System.getLogger(BrokerPool.class.getName());

    /** How long a robot waits for a lost connection that is being made again, s. */
    private static final double RECONNECTED_S = 2;

    private final BrokerOpener opener;
    private final Supplier<Sender> sender;
    private final Map<String, Entry> entries = new HashMap<>();
    private final AtomicLong requests = new AtomicLong();
    private volatile SiteObserver observer = (connection, address, by) -> () -> {};

    /** A connection and its users. */
    private static final class Entry {
        private final PooledBroker broker;
        private final Map<Object, String> sitesOfUsers = new IdentityHashMap<>();
        private final Map<String, AutoCloseable> observers = new HashMap<>();

        Entry(PooledBroker broker) {
            this.broker = broker;
        }
    }

    /**
     * Creates a pool without connections.
     *
     * @param opener makes the connections
     * @param sender the sender of the requests; asked for with the first one
     */
    BrokerPool(BrokerOpener opener, Supplier<Sender> sender) {
        this.opener = opener;
        this.sender = sender;
    }

    /** Sets what is called with the first robot of each site from now on. */
    void observe(SiteObserver newObserver) {
        observer = newObserver;
    }

    /**
     * Returns the connection to a broker, and opens it if nothing uses it yet. Blocks for at most 5 s.
     *
     * @param user keeps it open until it calls {@link #release}; compared by identity and counted once
     * @throws ConnectFailed if the broker cannot be reached; the user does not count then
     */
    PooledBroker acquire(BrokerAddress address, Object user, BotEnvironment environment) {
        Entry entry = enter(address, user, environment);
        try {
            if (!entry.broker.connect(RECONNECTED_S)) {
                throw new ConnectFailed(
                        ConnectFailed.Reason.NO_ANSWER,
                        "the broker " + address.hostAndPort() + " cannot be reached at the moment; is it running?");
            }
            observe(entry, address);
            return entry.broker;
        } catch (RuntimeException e) {
            release(address, user);
            throw e;
        }
    }

    private synchronized Entry enter(BrokerAddress address, Object user, BotEnvironment environment) {
        Entry entry = entries.computeIfAbsent(key(address), key -> {
            Sender by = sender.get();
            BrokerConnection made = opener.open(address, ConnectOptions.of("majic-user-" + by.session(), environment));
            return new Entry(new PooledBroker(made, by, requests));
        });
        entry.sitesOfUsers.put(user, address.site());
        return entry;
    }

    private void observe(Entry entry, BrokerAddress address) {
        AutoCloseable begun = observer.begin(entry.broker.connection(), address, entry.broker.sender());
        AutoCloseable before;
        synchronized (this) {
            boolean used = entry.sitesOfUsers.containsValue(address.site());
            before = used ? entry.observers.putIfAbsent(address.site(), begun) : begun;
        }
        if (before != null) {
            close(begun);
        }
    }

    /** Ends the use of a broker; the last user closes the connection. Takes at most 0.5 s. */
    void release(BrokerAddress address, Object user) {
        leave(address, user).forEach(BrokerPool::close);
    }

    /** Returns what nothing uses any more. */
    private synchronized List<AutoCloseable> leave(BrokerAddress address, Object user) {
        Entry entry = entries.get(key(address));
        String site = entry == null ? null : entry.sitesOfUsers.remove(user);
        if (entry == null || site == null) {
            return List.of();
        }
        List<AutoCloseable> unused = new ArrayList<>();
        if (!entry.sitesOfUsers.containsValue(site)) {
            Optional.ofNullable(entry.observers.remove(site)).ifPresent(unused::add);
        }
        if (entry.sitesOfUsers.isEmpty()) {
            entries.remove(key(address));
            unused.add(entry.broker.connection());
        }
        return unused;
    }

    private static void close(AutoCloseable unused) {
        try {
            unused.close();
        } catch (Exception e) {
            LOG.log(Level.WARNING, "the use of a broker did not end in order", e);
        }
    }

    private static String key(BrokerAddress address) {
        return address.secure() + " " + address.hostAndPort();
    }
}
