package majic.shared.broker;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * User names and passwords that the user has typed while the program runs. They are in memory only, and are used for
 * all further connections to the same broker. Thread-safe.
 */
public final class BrokerLogins {
    private static final Map<String, Login> TYPED = new ConcurrentHashMap<>();

    /** A user name and its password. */
    record Login(String user, String password) {
        /** Says whose it is; never contains the password. */
        @Override
        public String toString() {
            return user;
        }
    }

    private BrokerLogins() {}

    /**
     * Uses a user name and a password from now on.
     *
     * @param address of the broker; its site does not matter
     * @param user the name
     * @param password the password
     */
    public static void use(BrokerAddress address, String user, String password) {
        TYPED.put(address.hostAndPort(), new Login(user, password));
    }

    /** Returns what was typed last for a broker. */
    static Optional<Login> find(BrokerAddress address) {
        return Optional.ofNullable(TYPED.get(address.hostAndPort()));
    }
}
