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
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/**
 * The connections of a program to brokers: one for each broker, open while a shared robot uses it. If sites are
 * observed, a site of which a robot has been connected is observed until {@link #leaveSites()}, and its connection
 * stays open as long. Thread-safe.
 */
final class BrokerPool {
    private static final Logger LOG = LateLogger.of(BrokerPool.class);

    /** How long a robot waits for a lost connection that is being made again, s. */
    private static final double RECONNECTED_S = 2;

    private final BrokerOpener opener;
    private final Supplier<Sender> sender;
    private final Map<String, Entry> entries = new HashMap<>();
    private final AtomicLong requests = new AtomicLong();
    private volatile @Nullable SiteObserver observer;

    /** A connection and its users. */
    private static final class Entry {
        private final PooledBroker broker;

        /** Held while the observation of a site begins or ends. */
        private final Object observing = new Object();

        private final Map<Object, String> sitesOfUsers = new IdentityHashMap<>();
        private final Map<String, AutoCloseable> observers = new HashMap<>();

        Entry(PooledBroker broker) {
            this.broker = broker;
        }

        /** Compares by content, unlike {@link IdentityHashMap#containsValue}. */
        boolean isUsed(String site) {
            return sitesOfUsers.values().stream().anyMatch(site::equals);
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
     * Returns the connection to a broker, and opens it if nothing uses it yet. Blocks for at most 8 s.
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
            BrokerConnection made =
                    opener.open(address, ConnectOptions.of("majic-user-" + by.sessionHash(), environment));
            return new Entry(new PooledBroker(made, by, requests));
        });
        entry.sitesOfUsers.put(user, address.site());
        return entry;
    }

    /** Begins to observe a site once: two subscriptions to a topic would be one, which ends with the first of them. */
    private void observe(Entry entry, BrokerAddress address) {
        SiteObserver present = observer;
        synchronized (entry.observing) {
            if (present == null || isObserved(entry, address.site())) {
                return;
            }
            AutoCloseable begun = present.begin(entry.broker.connection(), address, entry.broker.sender());
            if (!isKept(entry, address.site(), begun)) {
                close(begun);
            }
        }
    }

    private synchronized boolean isObserved(Entry entry, String site) {
        return entry.observers.containsKey(site);
    }

    /** Returns false for a site whose last user has left meanwhile. */
    private synchronized boolean isKept(Entry entry, String site, AutoCloseable begun) {
        boolean used = entry.isUsed(site);
        if (used) {
            entry.observers.put(site, begun);
        }
        return used;
    }

    /** Stays at the site of a user when the last robot of it is released; the observation of a site uses it then. */
    synchronized void stay(BrokerAddress address) {
        Entry entry = entries.get(key(address));
        AutoCloseable observed = entry == null ? null : entry.observers.get(address.site());
        if (observed != null) {
            entry.sitesOfUsers.put(observed, address.site());
        }
    }

    /** Ends the observation of all sites that no robot uses. Takes at most 0.5 s for each broker. */
    void leaveSites() {
        for (Map.Entry<String, Entry> broker : present()) {
            observers(broker.getValue()).forEach(observed -> leave(broker.getKey(), broker.getValue(), observed));
        }
    }

    private synchronized List<Map.Entry<String, Entry>> present() {
        return List.copyOf(entries.entrySet());
    }

    private synchronized List<AutoCloseable> observers(Entry entry) {
        return List.copyOf(entry.observers.values());
    }

    /**
     * Ends the use of a broker; the last user closes the connection. Takes at most 0.5 s, but waits for the
     * subscription of another robot that is the first of its site.
     */
    void release(BrokerAddress address, Object user) {
        Entry entry;
        synchronized (this) {
            entry = entries.get(key(address));
        }
        if (entry != null) {
            leave(key(address), entry, user);
        }
    }

    private void leave(String broker, Entry entry, Object user) {
        synchronized (entry.observing) {
            unusedWithout(broker, entry, user).forEach(BrokerPool::close);
        }
    }

    /** Removes a user; returns what nothing uses any more. */
    private synchronized List<AutoCloseable> unusedWithout(String broker, Entry entry, Object user) {
        String site = entry.sitesOfUsers.remove(user);
        if (site == null) {
            return List.of();
        }
        List<AutoCloseable> unused = new ArrayList<>();
        if (!entry.isUsed(site)) {
            Optional.ofNullable(entry.observers.remove(site)).ifPresent(unused::add);
        }
        if (entry.sitesOfUsers.isEmpty()) {
            entries.remove(broker, entry);
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
