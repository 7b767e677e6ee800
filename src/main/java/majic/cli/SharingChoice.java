package majic.cli;

import java.io.Console;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.gui.kit.RobotSharing.Place;
import majic.program.Program;
import majic.program.UsageException;
import majic.program.UserFolder;
import majic.server.ListenKey;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerLogins;
import majic.shared.embedded.EmbeddedOptions;
import majic.shared.message.Sender;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** The options that share the robots with other desks over a broker. */
final class SharingChoice {
    private static final String OWN_BROKER = "127.0.0.1:1883";
    private static final String BROKER_USER = "MAJIC_MQTT_USER";
    private static final String BROKER_PASSWORD = "MAJIC_MQTT_PASSWORD";
    private static final int LOGIN_ATTEMPTS = 3;

    @Option(
            names = "--share",
            paramLabel = "URL",
            scope = ScopeType.INHERIT,
            description = "Share the robots with other desks over an MQTT 5 broker, such as mqtt://broker/lab.")
    private @Nullable String share;

    @Option(
            names = "--desk",
            paramLabel = "NAME",
            scope = ScopeType.INHERIT,
            description = "The name of this desk, as other desks show it (that of the computer).")
    private @Nullable String desk;

    @Option(
            names = "--person",
            paramLabel = "NAME",
            scope = ScopeType.INHERIT,
            description = "Your name, as other desks show it (the login name).")
    private @Nullable String person;

    @Option(
            names = "--share-only",
            paramLabel = "N",
            split = ",",
            scope = ScopeType.INHERIT,
            description = "With --share: share only the robots with these numbers, such as 1,3.")
    private List<Integer> only = List.of();

    @Option(
            names = "--vda5050",
            scope = ScopeType.INHERIT,
            description = "With --share: publish the robots as vehicles of VDA 5050, too.")
    private boolean vda5050;

    @Option(
            names = "--broker",
            paramLabel = "HOST:PORT",
            arity = "0..1",
            fallbackValue = OWN_BROKER,
            scope = ScopeType.INHERIT,
            description = "Start a broker (" + OWN_BROKER + "). At another address: with TLS, and with " + BROKER_USER
                    + " and " + BROKER_PASSWORD + ".")
    private @Nullable String broker;

    /** Returns whether one of the options is given. */
    boolean isGiven() {
        return share != null || broker != null || desk != null || person != null || isDetailed();
    }

    private boolean isDetailed() {
        return !only.isEmpty() || vda5050;
    }

    /** Refuses options that do not go together, and names that cannot be one. */
    void check() {
        if (share == null && isDetailed()) {
            throw new UsageException(
                    "--share-only and --vda5050 go with --share, as in --share mqtt://broker/lab --share-only 1,3");
        }
        try {
            if (desk != null) {
                Sender.checkDesk(desk);
            }
            if (share != null) {
                BrokerAddress.parse(share);
            }
        } catch (BotException e) {
            throw new UsageException(String.valueOf(e.getMessage()));
        }
    }

    /**
     * Starts the broker and begins to share the robots, as far as that is requested. Blocks until both is done.
     *
     * @throws majic.bot.BotException if the broker cannot be started or reached, or the name is taken
     * @throws IOException if there is no key for TLS
     */
    void start(Program program) throws IOException {
        if (broker != null) {
            InetSocketAddress address = StartOptions.address("--broker", broker, OWN_BROKER);
            program.startBroker(options(address, program.folder()));
            System.err.println("majic: the broker runs at port " + address.getPort());
        }
        program.sharing().useNames(desk, person);
        if (share != null) {
            Place suggested = program.sharing().suggested();
            Place place = new Place(share, suggested.desk(), suggested.person());
            Set<Integer> numbers = new TreeSet<>(only);
            connect(share, () -> program.sharing().start(place, numbers, vda5050));
            System.err.println("majic: sharing robots as " + place.desk() + " at " + place.broker());
        }
    }

    /** The broker of this program. Beyond this computer it uses the key of {@code --listen}, and needs a password. */
    private static EmbeddedOptions options(InetSocketAddress address, UserFolder folder) throws IOException {
        String user = System.getenv(BROKER_USER);
        String password = System.getenv(BROKER_PASSWORD);
        boolean withUser = user != null && !user.isEmpty();
        if (address.isUnresolved() || address.getAddress().isLoopbackAddress() || !withUser) {
            return new EmbeddedOptions(address, null, "", withUser ? user : null, withUser ? password : null);
        }
        ListenKey key = ListenKey.in(folder.path());
        return new EmbeddedOptions(address, key.file(), ListenKey.PASSWORD, user, password);
    }

    /**
     * Runs what connects with a broker, again with the user name and password that the user types in the terminal while
     * the broker refuses those that it was given.
     *
     * @param broker the address
     * @param connecting connects
     * @throws ConnectFailed if it cannot be connected, there is no terminal, or the user types nothing
     */
    private static void connect(String broker, Runnable connecting) {
        Console terminal = System.console();
        for (int attempt = 1; ; attempt++) {
            try {
                connecting.run();
                return;
            } catch (ConnectFailed e) {
                if (e.reason() != Reason.WRONG_LOGIN
                        || terminal == null
                        || attempt > LOGIN_ATTEMPTS
                        || !readLogin(terminal, broker)) {
                    throw e;
                }
            }
        }
    }

    private static boolean readLogin(Console terminal, String broker) {
        BrokerAddress address = BrokerAddress.parse(broker);
        String user = terminal.readLine("User at the broker %s: ", address.hostAndPort());
        char[] password = user == null || user.isBlank() ? null : terminal.readPassword("Password: ");
        if (password == null) {
            return false;
        }
        BrokerLogins.use(address, user.strip(), new String(password));
        return true;
    }
}
