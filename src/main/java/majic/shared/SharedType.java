package majic.shared;

import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.MajicBot;
import majic.driver.MotionlessBot;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.message.DeskName;
import majic.shared.message.Sender;
import majic.shared.panel.SharedReplay;
import org.jspecify.annotations.Nullable;

/**
 * Robots that another desk shares, among the types of robots. All robots that are made by one object of this class use
 * one connection for each broker.
 */
public final class SharedType implements BotType {
    /** From the libraries for MQTT and JSON, which are optional for programs that embed robots. */
    private static final List<String> LIBRARIES =
            List.of("com.hivemq.client.mqtt.mqtt5.Mqtt5Client", "com.fasterxml.jackson.databind.ObjectMapper");

    private final BrokerOpener opener;
    private final BrokerPool brokers;
    private final AtomicReference<@Nullable Sender> sender = new AtomicReference<>();
    private volatile Supplier<Sender> senders = SharedType::ofThisComputer;

    /** Used by the service loader. */
    public SharedType() {
        this(BrokerConnection::open);
    }

    /**
     * A type with connections of another kind.
     *
     * @param opener makes the connections to brokers
     */
    public SharedType(BrokerOpener opener) {
        this.opener = opener;
        this.brokers = new BrokerPool(opener, this::sender);
    }

    /**
     * Sets the sender of all requests; without it, the user of this computer at a desk with the computer's name.
     *
     * @param newSender gives the desk, its person and the session of this run; called once, with the first robot
     */
    public void sendAs(Supplier<Sender> newSender) {
        senders = newSender;
    }

    private Sender sender() {
        Sender known = sender.get();
        if (known != null) {
            return known;
        }
        sender.compareAndSet(null, senders.get());
        return sender();
    }

    private static Sender ofThisComputer() {
        return Sender.ofThisRun(DeskName.ofThisComputer(), System.getProperty("user.name", ""));
    }

    /**
     * Sets what is done at each site of which a robot is used. It goes on, with a connection to the broker, when the
     * last robot of the site is closed, until {@link #leaveSites()}.
     *
     * @param observer called for the first robot of each site from now on
     */
    public void observeSites(SiteObserver observer) {
        brokers.observe(observer);
    }

    /** Ends what is done at each site of which no robot is used any more. Takes at most 0.5 s for each broker. */
    public void leaveSites() {
        brokers.leaveSites();
    }

    @Override
    public String name() {
        return BrokerAddress.SCHEME;
    }

    @Override
    public List<String> otherSchemes() {
        return List.of(BrokerAddress.SECURE_SCHEME);
    }

    @Override
    public boolean isOneOfSeveral() {
        return true;
    }

    @Override
    public String label() {
        return "Shared robot";
    }

    @Override
    public String make() {
        return "Robot of another desk";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP);
    }

    @Override
    public int defaultPort(String scheme) {
        return BrokerAddress.defaultPort(scheme.equals(BrokerAddress.SECURE_SCHEME));
    }

    @Override
    public boolean canListRobots() {
        return true;
    }

    @Override
    public Map<String, String> robotsAt(BotAddress address, BotEnvironment environment) {
        return new SiteListing(opener, BrokerAddress.parse(address.toString()), environment).robots();
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        requireLibraries();
        return SharedAddress.isListing(address)
                ? listed(address, environment)
                : new MajicShared(address, this, environment);
    }
    /** Connecting to a whole site or desk fails with a list of the robots that are shared there. */
    private MajicBot listed(BotAddress address, BotEnvironment environment) {
        BrokerAddress site = BrokerAddress.parse(address.toString());
        return new MotionlessBot(this, 1, true, environment, site + " is no robot") {
            @Override
            protected void open() {
                SiteListing listing = new SiteListing(opener, site, environment);
                throw new ConnectFailed(Reason.OTHER, listing.question(listing.robots()));
            }
        };
    }

    /**
     * Refuses to go on without the libraries.
     *
     * @throws BotException if one is missing; the message names both
     */
    private static void requireLibraries() {
        for (String name : LIBRARIES) {
            try {
                Class.forName(name, false, SharedType.class.getClassLoader());
            } catch (ClassNotFoundException e) {
                throw new BotException(
                        "robots of other desks need the libraries hivemq-mqtt-client and jackson-databind: add both to the"
                                + " class path",
                        e);
            }
        }
    }

    BrokerPool brokers() {
        return brokers;
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new SharedReplay(recorded);
    }

    @Override
    public String advice() {
        return "Does the broker run, and does the robot's desk share it (./majic --share mqtt://BROKER/SITE --desk NAME)?"
                + " add mqtt://BROKER/SITE/ with a slash at the end lists what is there.";
    }
}
