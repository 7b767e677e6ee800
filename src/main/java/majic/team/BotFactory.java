package majic.team;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.TreeSet;
import java.util.WeakHashMap;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.lab.LabAccess;
import majic.link.SerialPorts;
import majic.text.ClassReason;
import majic.text.LateLogger;
import majic.text.Suggestion;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Creates robot drivers from the addresses that users type. Thread-safe. */
public final class BotFactory {
    private static final System.Logger LOG = LateLogger.of(BotFactory.class);

    /**
     * The types in the order of the thesis, then the one of today's robots, those of other desks; others follow by
     * name.
     */
    private static final List<String> ORDER = List.of("aibo", "pioneer", "hemisson", "ros", "mavlink", "mqtt");

    private static final Pattern SERVER = Pattern.compile(
            "(?<type>\\w+)(?:\\+\\w+)?:(?:tcp:)?//(?<host>\\[[^]]+]|[^/:?]+)(?<port>:\\d+)?(?<rest>.*)");

    /** An option that says how a robot is driven, and not which one it is. */
    private static final Pattern DRIVEN_BY = Pattern.compile("\\?params=.*");

    private static final Pattern PORT = Pattern.compile("(?<type>\\w+)(?:\\+\\w+)?:(?!(?:tcp:)?//)(?<port>.+)");

    private final List<BotType> types;
    private final Settings settings;
    private final Map<MajicBot, String> inLab = Collections.synchronizedMap(new WeakHashMap<>());
    private volatile @Nullable LabAccess lab;

    /**
     * Creates a factory for the given robot types.
     *
     * @param types all types there are, in the order the Add dialog shows them
     * @param settings the stored user settings
     */
    public BotFactory(List<BotType> types, Settings settings) {
        this.types = List.copyOf(types);
        this.settings = settings;
    }

    /**
     * Finds the robot types that a class loader offers as services.
     *
     * @param loader also looks into its parents
     * @return MAJIC's own first, then the others by name; a broken one is logged and left out
     */
    public static List<BotType> types(ClassLoader loader) {
        List<BotType> types = new ArrayList<>();
        Iterator<BotType> found = ServiceLoader.load(BotType.class, loader).iterator();
        boolean more = true;
        while (more) {
            more = takeNext(found, types);
        }
        types.sort(BotFactory::inOrder);
        return types;
    }

    private static int inOrder(BotType one, BotType other) {
        int places = Integer.compare(place(one), place(other));
        return places == 0 ? one.name().compareTo(other.name()) : places;
    }

    /** Adds the next type; returns false at the end. A type that cannot be instantiated is skipped. */
    private static boolean takeNext(Iterator<BotType> found, List<BotType> types) {
        try {
            boolean more = found.hasNext();
            if (more) {
                types.add(found.next());
            }
            return more;
        } catch (ServiceConfigurationError | LinkageError e) {
            LOG.log(Level.WARNING, "a plug-in cannot be used: " + e.getMessage(), e);
            return true;
        }
    }

    private static int place(BotType type) {
        int place = ORDER.indexOf(type.name());
        return place < 0 ? ORDER.size() : place;
    }

    /**
     * Returns all robot types.
     *
     * @return in the order the Add dialog shows them
     */
    public List<BotType> types() {
        return types;
    }

    /**
     * Returns the simulated lab, if one runs.
     *
     * @return the lab last passed to {@link #useLab}
     */
    public Optional<LabAccess> lab() {
        return Optional.ofNullable(lab);
    }

    /**
     * Makes addresses with {@code sim:} refer to the robots of a lab.
     *
     * @param newLab a running lab
     */
    public void useLab(LabAccess newLab) {
        lab = newLab;
    }

    /**
     * Creates the driver for an address, without contacting the robot.
     *
     * @param text as typed: {@code pioneer://10.0.0.5:8101}, {@code hemisson:COM3}, {@code sim:aibo}
     * @return the driver, not connected
     * @throws BotException if the address or its type is unknown; the message says what would be right
     */
    public MajicBot create(String text) {
        BotAddress address = parse(text);
        if (address.scheme().equals(BotAddress.SIMULATED)) {
            return createSimulated(address);
        }
        return driver(address, TimeSource.system());
    }

    /**
     * Takes an address apart.
     *
     * @param text as typed
     * @return the address; its type may be unknown
     * @throws BotException if it is no address; the message shows a right one, that of the lab's robot if its name was
     *     typed
     */
    public BotAddress parse(String text) {
        LabAccess running = lab;
        if (running != null && running.robots().contains(text)) {
            throw new BotException(
                    text + ": not a robot's address; did you mean " + BotAddress.SIMULATED + ":" + text + "?");
        }
        return BotAddress.parse(text);
    }

    /**
     * Returns whether two addresses are those of one robot. Upper and lower case, the makers' library, a parameter
     * file, {@code tcp:} and a usual port that only one of them has make no difference, nor does a link in place of a
     * serial port. Where an address names one of several robots behind a server, its case counts, since theirs does,
     * but further slashes do not.
     *
     * @param one as typed
     * @param other as typed
     * @return false for two names of one computer, which are not looked up
     */
    public boolean isSameRobot(String one, String other) {
        return complete(one).equals(complete(other));
    }

    /**
     * Returns what an address says about how its robot is driven: the makers' library and the parameter file.
     *
     * @param text an address
     * @return equal for two addresses that make the same driver for one robot
     */
    public static String drivenBy(String text) {
        Matcher option = DRIVEN_BY.matcher(text);
        return BotAddress.parse(text).library().orElse("") + (option.find() ? option.group() : "");
    }

    /**
     * Returns what identifies the device behind an address at present, if that can be found out without contacting it.
     * May block for seconds on some systems.
     *
     * @param text as typed
     * @return for a serial port the adapter that it belongs to now; empty if the system does not identify it, and for
     *     other addresses
     */
    public String deviceAt(String text) {
        return serialPort(text).map(BotFactory::adapter).orElse("");
    }

    /**
     * Returns the names of serial ports that stay the same adapter's. Reads files at most.
     *
     * @return as they stand in addresses behind the type
     */
    public List<String> serialPorts() {
        return SerialPorts.system().namesThatStay();
    }

    private static String adapter(String port) {
        try {
            return SerialPorts.system()
                    .find(port)
                    .map(SerialPorts.Port::adapter)
                    .orElse("");
        } catch (IOException e) {
            return "";
        }
    }

    /** The serial port in an address; empty if it has none. */
    private Optional<String> serialPort(String text) {
        Matcher form = PORT.matcher(DRIVEN_BY.matcher(text).replaceFirst(""));
        if (!form.matches()) {
            return Optional.empty();
        }
        String scheme = form.group("type").toLowerCase(Locale.ROOT);
        return types.stream()
                .filter(type -> type.isMeantBy(scheme))
                .filter(type -> type.reaches().contains(BotType.Reach.SERIAL))
                .findFirst()
                .map(type -> form.group("port"));
    }

    private String complete(String text) {
        String plain = DRIVEN_BY.matcher(text).replaceFirst("");
        return serialPort(plain)
                .map(port -> BotAddress.parse(plain).type() + ":"
                        + SerialPorts.system().device(port))
                .orElseGet(() -> completeServer(plain));
    }

    private String completeServer(String text) {
        Matcher server = SERVER.matcher(text);
        if (!server.matches()) {
            return text.toLowerCase(Locale.ROOT);
        }
        String scheme = server.group("type").toLowerCase(Locale.ROOT);
        Optional<BotType> meant =
                types.stream().filter(type -> type.isMeantBy(scheme)).findFirst();
        String port = meant.map(type -> ":" + type.defaultPort(scheme)).orElse("");
        String rest = server.group("rest");
        return scheme + "://" + server.group("host").toLowerCase(Locale.ROOT)
                + Objects.requireNonNullElse(server.group("port"), port)
                + (meant.filter(BotType::isOneOfSeveral).isPresent() ? one(rest) : rest.toLowerCase(Locale.ROOT));
    }

    /** One of several robots: a path with single slashes and none at its end, and options. */
    private static String one(String rest) {
        int options = rest.indexOf('?');
        String path = options < 0 ? rest : rest.substring(0, options);
        return path.replaceAll("/+", "/").replaceFirst("/$", "") + rest.substring(path.length());
    }

    private MajicBot createSimulated(BotAddress address) {
        LabAccess running = lab;
        if (running == null) {
            throw new BotException(address + ": no simulated lab runs here; start MAJIC with --lab");
        }
        BotAddress real = running.address(address.rest())
                .orElseThrow(() -> new BotException(address + ": the lab has no " + address.rest() + " (it has "
                        + String.join(", ", running.robots()) + ")"));
        MajicBot bot = driver(real, running.time());
        inLab.put(bot, address.rest());
        return bot;
    }

    /**
     * Returns the name of a robot in the simulated lab.
     *
     * @param bot a robot
     * @return its name in the lab it was made for; empty if it was not made for a lab
     */
    public Optional<String> nameInLab(MajicBot bot) {
        return Optional.ofNullable(inLab.get(bot));
    }

    private MajicBot driver(BotAddress address, TimeSource time) {
        return loading(address, () -> {
            BotType type = type(address.type());
            address.libraryAmong(type.libraries());
            return type.create(address, new BotEnvironment(time, settings));
        });
    }

    private static <T> T loading(BotAddress address, Supplier<T> code) {
        try {
            return code.get();
        } catch (LinkageError e) {
            throw new BotException(address + ": the driver cannot be loaded: " + ClassReason.of(e), e);
        }
    }

    /**
     * Finds the robots behind an address that stands for several. Blocks for some seconds.
     *
     * @param text with a slash at its end: {@code mqtt://broker/lab/}
     * @return what each robot is, by its address; empty if there are none
     * @throws BotException if the address is wrong, or nothing answers there; the message says what would be right
     */
    public Map<String, String> robotsAt(String text) {
        BotAddress address = BotAddress.parse(text);
        return loading(
                address,
                () -> type(address.type()).robotsAt(address, new BotEnvironment(TimeSource.system(), settings)));
    }

    /**
     * Finds the robots of a type that send to this computer unasked. Blocks for some seconds.
     *
     * @param type of the robots
     * @return what each robot is, by its address; empty if there are none
     * @throws BotException if the usual port cannot be opened
     */
    public Map<String, String> robotsSending(BotType type) {
        return type.robotsSending(new BotEnvironment(TimeSource.system(), settings));
    }

    /**
     * Returns the robot type with a given name.
     *
     * @param name as in addresses; case is ignored
     * @return the type
     * @throws BotException if there is none; the message lists the existing types
     */
    public BotType type(String name) {
        Collection<String> names =
                new TreeSet<>(types.stream().map(BotType::name).toList());
        return types.stream()
                .filter(type -> type.isMeantBy(name))
                .findFirst()
                .orElseThrow(() -> new BotException(name + ": no such type of robot (there are "
                        + String.join(", ", names) + ")" + Suggestion.didYouMean(name, names)));
    }

    /** Half a sentence about a better name of a serial port; empty if there is none. */
    private String nameThatStays(String text) {
        try {
            Optional<String> port = serialPort(text);
            Optional<SerialPorts.Port> found =
                    port.isEmpty() ? Optional.empty() : SerialPorts.system().find(port.get());
            return found.filter(SerialPorts.Port::stays)
                    .filter(better -> !better.name().equals(port.orElseThrow()))
                    .map(better -> "; the name of this port can change, "
                            + BotAddress.parse(text).scheme() + ":" + better.name() + " stays")
                    .orElse("");
        } catch (IOException e) {
            return "";
        }
    }

    /**
     * Connects to an address to find out what answers there, and closes the connection. Blocks for at most the driver's
     * connection timeout.
     *
     * @param text as typed
     * @return one or two sentences for the user: what answered, or what went wrong and what to try
     * @throws BotException if the address itself is wrong, or nothing answers; the message says what to try
     */
    public String probe(String text) {
        MajicBot bot = create(text);
        try (bot) {
            bot.connect();
            return bot.introduction() + " answers" + nameThatStays(text);
        } catch (BotException e) {
            throw new BotException(bot.type().adviceAfter(String.valueOf(e.getMessage())), e);
        }
    }
}
