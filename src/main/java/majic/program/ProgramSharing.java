package majic.program;

import java.util.Optional;
import java.util.Set;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.gui.kit.RobotSharing;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerLogins;
import majic.shared.broker.ConnectOptions;
import majic.shared.desk.DeskMap;
import majic.shared.desk.DeskOptions;
import majic.shared.desk.DeskSharing;
import majic.shared.message.DeskName;
import majic.team.Team;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Shares the robots of a program's team over a broker, as the command line or the window requests it. Messages between
 * desks are late by the system's clock, however fast a simulated lab runs. Thread-safe.
 */
public final class ProgramSharing implements RobotSharing {
    private static final String BROKER = "sharing.broker";
    private static final String DESK = "sharing.desk";
    private static final String PERSON = "sharing.person";

    private final Team team;
    private final DeskMap map;
    private final BotEnvironment environment;
    private @Nullable DeskSharing sharing;
    private @Nullable Place place;
    private boolean starting;
    private volatile @Nullable String chosenDesk;
    private volatile @Nullable String chosenPerson;

    /**
     * Shares nothing yet.
     *
     * @param map the map of the team
     */
    ProgramSharing(Team team, Settings settings, DeskMap map) {
        this.team = team;
        this.map = map;
        this.environment = new BotEnvironment(TimeSource.system(), settings);
    }

    /**
     * Chooses the names under which other desks see this program, until it ends.
     *
     * @param desk the name of this desk; null for that of last time, or of the computer
     * @param person the name of the user; null for that of last time, or the login name
     */
    public void useNames(@Nullable String desk, @Nullable String person) {
        chosenDesk = desk;
        chosenPerson = person;
    }

    @Override
    public Place suggested() {
        Settings settings = environment.settings();
        return new Place(
                settings.get(BROKER).orElse(""),
                Optional.ofNullable(chosenDesk).or(() -> settings.get(DESK)).orElseGet(DeskName::ofThisComputer),
                Optional.ofNullable(chosenPerson)
                        .or(() -> settings.get(PERSON))
                        .orElseGet(() -> System.getProperty("user.name", "")));
    }

    @Override
    public synchronized Optional<Place> now() {
        DeskSharing running = sharing;
        return running == null || !running.problem().isEmpty() ? Optional.empty() : Optional.ofNullable(place);
    }

    @Override
    public boolean isConnected() {
        DeskSharing running = running();
        return running != null && running.isConnected();
    }

    private synchronized @Nullable DeskSharing running() {
        return sharing;
    }

    @Override
    public void start(Place wanted) {
        start(wanted, Set.of(), false);
    }

    /**
     * Begins to share robots. Blocks for at most 13 s.
     *
     * @param wanted where, and under which names
     * @param only the numbers of the robots; empty for all
     * @param vda5050 whether they are published as vehicles of VDA 5050, too
     * @throws BotException as {@link RobotSharing#start}
     */
    public void start(Place wanted, Set<Integer> only, boolean vda5050) {
        BrokerAddress address = BrokerAddress.parse(wanted.broker());
        DeskOptions options =
                new DeskOptions(address.site(), wanted.desk(), wanted.person(), Version.text(), only, vda5050);
        begin();
        try {
            DeskSharing started = new DeskSharing(
                    team,
                    options,
                    (clientId, will) -> BrokerConnection.open(
                            address, ConnectOptions.of(clientId, environment).withWill(will)),
                    map);
            started.start();
            become(started, wanted);
        } finally {
            end();
        }
        keep(wanted);
    }

    private synchronized void begin() {
        if (starting || now().isPresent()) {
            throw new BotException("the robots are shared already; stop that first");
        }
        starting = true;
    }

    private synchronized void become(DeskSharing started, Place wanted) {
        sharing = started;
        place = wanted;
    }

    private synchronized void end() {
        starting = false;
    }

    private void keep(Place used) {
        Settings settings = environment.settings();
        try {
            settings.put(BROKER, used.broker());
            settings.put(DESK, used.desk());
            settings.put(PERSON, used.person());
        } catch (BotException e) {
            team.notice(String.valueOf(e.getMessage()));
        }
    }

    @Override
    public void useLogin(String broker, String user, char[] password) {
        BrokerLogins.use(BrokerAddress.parse(broker), user, new String(password));
    }

    @Override
    public void stop() {
        DeskSharing ended;
        synchronized (this) {
            ended = sharing;
            sharing = null;
            place = null;
        }
        if (ended != null) {
            ended.close();
        }
    }
}
