package majic.script;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.log.Line;
import majic.log.ParameterLog;
import majic.log.Sampling;
import majic.log.SessionListener;
import majic.log.SessionLog;
import majic.log.SessionOutput;
import majic.nav.CurrentMap;
import majic.nav.grid.NavigationMap;
import majic.script.commands.TeamScript;
import majic.script.conditions.Selection;
import majic.script.help.Completer;
import majic.script.record.SessionRecord;
import majic.script.run.Plotting;
import majic.script.run.Questions;
import majic.script.run.RandomNumbers;
import majic.script.run.RobotConnector;
import majic.script.run.SessionState;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.Advice;

/**
 * What all parts of one running MAJIC share: the team, the factory of robots, and the output. Window, console and every
 * socket have a {@link MajicParser} each, on the same session. It closes nothing by itself. Thread-safe.
 */
public final class Session {
    private static final Path ACTS = Path.of("acts");

    private final Team team;
    private final BotFactory factory;
    private final SessionLog log;
    private final SessionOutput output;
    private final List<String> robotTypes;
    private final SessionState state;
    private final ActOffers offers;
    private final RobotConnector connector;
    private final Plotting plotting = new Plotting();
    private final CurrentMap map = new CurrentMap(this::newsOfMap, this::placeInLab);

    /**
     * A session without listeners.
     *
     * @param team the robots; its answers and notices go to the session's listeners from now on
     * @param factory makes robots for {@code add}
     * @param log gets every line
     * @param acts where behaviours are found
     * @param quit what {@code quit} does; must return at once
     */
    public Session(Team team, BotFactory factory, SessionLog log, ActCatalog acts, Runnable quit) {
        this.team = team;
        this.factory = factory;
        this.log = log;
        this.output = new SessionOutput(log);
        this.robotTypes = factory.types().stream().map(BotType::name).toList();
        SessionRecord record = new SessionRecord(team);
        this.offers = new ActOffers(output, acts);
        this.connector = new RobotConnector(team, factory, output, record);
        ParameterLog readings = new ParameterLog();
        Sampling sampling = new Sampling(readings, team.time(), notice -> output.send(Line.Kind.NOTICE, notice));
        SessionActs runner = new SessionActs(team, output, acts, offers, plotting);
        this.state = new SessionState(
                team,
                output,
                record,
                factory,
                connector,
                runner,
                readings,
                sampling,
                plotting,
                map,
                new Questions(team.changes(), team.time()),
                new RandomNumbers(factory),
                quit);
        log.onTrouble(this::alarm);
        map.navigator().useGiveWay(new TeamGiveWay(team, map, this::isOfAnotherDesk));
        team.addListener(new TeamRelay());
    }

    /**
     * Creates a session for a program that embeds MAJIC Script: with the types of robots on its class path, the acts
     * that come with MAJIC and those in the folder {@code acts} of the working directory. It has no log file, and
     * {@code quit} does nothing.
     *
     * @param team the robots, as in the constructor
     * @return the session; give it a listener and make a {@link MajicParser} for it
     */
    public static Session of(Team team) {
        Settings settings = Settings.inMemory();
        BotFactory factory = new BotFactory(BotFactory.types(Session.class.getClassLoader()), settings);
        return new Session(team, factory, SessionLog.none(), new ActCatalog(ACTS, new ActTrust(settings)), () -> {});
    }

    /**
     * Reports that something went wrong in MAJIC itself, as an error.
     *
     * @param text a sentence
     */
    public void alarm(String text) {
        output.send(Line.Kind.ERROR, text);
    }

    /**
     * The robots.
     *
     * @return the team
     */
    public Team team() {
        return team;
    }

    /**
     * Where robots come from.
     *
     * @return the factory
     */
    public BotFactory factory() {
        return factory;
    }

    /**
     * The log of all lines.
     *
     * @return the session log
     */
    public SessionLog log() {
        return log;
    }

    /**
     * The behaviours that the user can choose from.
     *
     * @return for windows; the script finds them by itself
     */
    public ActOffers offers() {
        return offers;
    }

    /**
     * Sets what the command {@code plot} does; without this call it fails, because there is no window.
     *
     * @param window receives the numbers of the robots and the names of the parameters, on any thread; must return at
     *     once
     */
    public void usePlots(BiConsumer<List<Integer>, List<String>> window) {
        plotting.use(window);
    }

    /**
     * The map of the team.
     *
     * @return the same object at each call
     */
    public CurrentMap map() {
        return map;
    }

    private boolean isOfAnotherDesk(Member member) {
        return connector
                .address(member)
                .map(BotAddress::parse)
                .filter(BotAddress::isOfAnotherDesk)
                .isPresent();
    }

    private void newsOfMap(MajicBot bot, String text) {
        team.members().stream()
                .filter(member -> member.bot() == bot)
                .forEach(member -> output.send(Line.Kind.NOTICE, member.number() + ": " + member.label() + " " + text));
    }

    /** In the lab a robot that was not placed begins a map where it stands in the room, as the team map shows it. */
    private Optional<Pose> placeInLab(MajicBot bot) {
        return factory.lab()
                .filter(lab -> bot.time() == lab.time())
                .flatMap(lab -> factory.nameInLab(bot).map(lab.truePoses()::get));
    }

    /** Sends a line if STOP is latched, with its origin, for listeners that were added after it. */
    public void reportLatch() {
        if (team.isLatched()) {
            output.send(Line.Kind.NOTICE, team.latchText());
        }
    }

    /**
     * Passes all lines from now on to a listener, on a thread of its own.
     *
     * @param listener what receives the lines
     */
    public void addListener(SessionListener listener) {
        output.addListener(listener);
    }

    /**
     * Removes a listener, once all lines so far were passed to it.
     *
     * @param listener one that was added
     */
    public void removeListener(SessionListener listener) {
        output.removeListener(listener);
    }

    /**
     * Runs a task on a listener's thread once all lines so far were passed to it. Returns at once.
     *
     * @param listener one that was added; nothing happens for another
     * @param task what to do; must return soon
     */
    public void afterwards(SessionListener listener, Runnable task) {
        output.afterwards(listener, task);
    }

    /** Waits until all listeners have received all lines so far, for one second at most. */
    public void flush() {
        output.flush();
    }

    /**
     * Records that a robot was added to the team past the script, by a dialog for instance, so that a saved session has
     * it.
     *
     * @param member the robot
     * @param address where it is, as {@code add} would take it
     */
    public void joined(Member member, String address) {
        connector.joined(member, address);
    }

    /**
     * The robot at an address that has lost its link or is being connected again. {@code add} connects it again under
     * its number instead of taking in another one; a dialog that connects robots must do the same.
     *
     * @param address as {@code add} would take it
     * @return a robot of the team; empty if none is lost there or being connected again
     */
    public Optional<Member> lostAt(String address) {
        return connector
                .lost(address, OptionalInt.empty())
                .or(() -> connector.connecting(address, OptionalInt.empty()));
    }

    /**
     * Checks that no robot of the team is connected at an address, as {@code add} does.
     *
     * @param address as {@code add} would take it
     * @throws majic.bot.BotException naming the robot that is
     */
    public void checkUnused(String address) {
        connector.checkUnused(address);
    }

    /**
     * Returns the address of a robot.
     *
     * @param member a robot of the team
     * @return as {@code add} takes it; empty for a robot that was added without one
     */
    public Optional<String> address(Member member) {
        return connector.address(member);
    }

    /**
     * Returns the team as a script, as {@code save team} writes it, but without the calibrations, which the settings of
     * this computer have.
     *
     * @return what {@link SavedTeam#parse} takes
     */
    public String teamScript() {
        return TeamScript.of(state).withoutCalibrations();
    }

    /** Returns the questions of scripts that wait for an answer. */
    public Questions questions() {
        return state.questions();
    }

    SessionOutput output() {
        return output;
    }

    SessionState state() {
        return state;
    }

    /** The words that stand for robots: types, and the names that robots have. */
    Collection<String> robotWords() {
        List<String> words = new ArrayList<>(robotTypes);
        words.addAll(new Selection(team).names());
        return words;
    }

    Completer completer() {
        return new Completer(team, factory, new Selection(team)::present, this::places, offers);
    }

    private List<String> places() {
        return map.get().stream()
                .flatMap(known -> known.places().stream())
                .map(NavigationMap.Place::name)
                .toList();
    }

    /** Turns the events of the team into lines of the session. */
    private final class TeamRelay implements TeamListener {
        @Override
        public void answered(Answer answer) {
            output.send(kindOf(answer.outcome()), answer.text(), answer.asker());
        }

        private static Line.Kind kindOf(Answer.Outcome outcome) {
            return switch (outcome) {
                case DONE, STOPPED, NOT_RUN -> Line.Kind.ANSWER;
                case FAILED -> Line.Kind.FAILURE;
                case NOT_STOPPED -> Line.Kind.ALARM;
            };
        }

        @Override
        public void stopOverdue(Collection<Member> members, double seconds) {
            members.forEach(member -> output.send(
                    Line.Kind.ALARM,
                    member.number() + ": " + member.label() + " has not confirmed its stop within " + seconds
                            + " s; it may still move"));
        }

        @Override
        public void noticed(int robot, String message) {
            output.send(Line.Kind.NOTICE, message);
        }

        @Override
        public void lost(Member member, String reason) {
            String told = connector
                    .address(member)
                    .map(address -> Advice.joined(reason, "\"add " + address + "\" connects it again"))
                    .orElse(reason);
            output.send(Line.Kind.ALARM, member.number() + ": " + told);
        }

        @Override
        public void regained(Member member) {
            String where =
                    connector.address(member).map(address -> " at " + address).orElse("");
            String label = member.label();
            output.send(Line.Kind.ANSWER, member.number() + ": " + label + where + " connected again");
        }

        @Override
        public void added(Member member) {
            map.follow(member.bot());
        }

        @Override
        public void removed(Member member) {
            map.unfollow(member.bot());
            output.send(Line.Kind.ANSWER, "Bot " + member.number() + " is dead");
        }

        @Override
        public void latchChanged(boolean latched) {
            output.send(
                    Line.Kind.NOTICE,
                    latched ? team.latchText() : "released: motion is allowed again, nothing resumes by itself");
        }
    }
}
