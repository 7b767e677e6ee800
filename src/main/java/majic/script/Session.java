package majic.script;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import majic.act.Acts;
import majic.log.ParameterLog;
import majic.log.Sampling;
import majic.log.SessionLog;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.StopCount;
import majic.team.Team;
import majic.team.TeamListener;
import org.jspecify.annotations.Nullable;

/**
 * What everything in one running MAJIC has in common: the team, where robots come from, and what is said. Window,
 * console and every socket have a {@link MajicParser} each, on the same session. It closes nothing by itself.
 * Thread-safe.
 */
public final class Session {
    private static final Logger LOG = System.getLogger(Session.class.getName());

    private static final long FLUSH_BOUND_MS = 1000;

    private final Team team;
    private final BotFactory factory;
    private final SessionLog log;
    private final Runnable quit;
    private final List<Listening> listeners = new CopyOnWriteArrayList<>();
    private final Object saying = new Object();
    private final Behaviours behaviours;
    private final ActOffers offers;
    private final Comings comings;
    private final SessionRecord sessionRecord;
    private final ParameterLog parameterLog = new ParameterLog();
    private final Sampling sampling;

    /**
     * A session with nobody listening yet.
     *
     * @param team the robots; its answers and notices are told to the session's listeners from now on
     * @param factory makes robots for {@code add}
     * @param log gets everything that is said
     * @param acts where behaviours are found
     * @param quit what {@code quit} does; must return at once
     */
    public Session(Team team, BotFactory factory, SessionLog log, Acts acts, Runnable quit) {
        this.team = team;
        this.factory = factory;
        this.log = log;
        this.quit = quit;
        this.behaviours = new Behaviours(this, acts);
        this.offers = new ActOffers(this, acts);
        this.comings = new Comings(this);
        this.sessionRecord = new SessionRecord(team);
        this.sampling = new Sampling(parameterLog, team.time(), notice -> say(Line.Kind.NOTICE, notice));
        log.onTrouble(this::alarm);
        team.addListener(new TeamRelay());
    }

    /**
     * Says that something went wrong in MAJIC itself, as an error.
     *
     * @param text a sentence
     */
    public void alarm(String text) {
        say(Line.Kind.ERROR, text);
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
     * What is kept of all that is said.
     *
     * @return the session log
     */
    public SessionLog log() {
        return log;
    }

    /**
     * The behaviours a person can choose from.
     *
     * @return for windows; the script finds them by itself
     */
    public ActOffers offers() {
        return offers;
    }

    /**
     * Begins to tell somebody what is said, on a thread of its own.
     *
     * @param listener who
     */
    public void addListener(SessionListener listener) {
        listeners.add(new Listening(listener).start());
    }

    /**
     * Ends telling somebody, once all that was said so far has been told.
     *
     * @param listener who was added
     */
    public void removeListener(SessionListener listener) {
        for (Listening listening : listeners) {
            if (listening.isTo(listener) && listeners.remove(listening)) {
                listening.end();
            }
        }
    }

    /**
     * Does something on a listener's thread once the listener was told all that was said so far. Returns at once.
     *
     * @param listener one that was added; nothing happens for another
     * @param task what to do; must return soon
     */
    public void afterwards(SessionListener listener, Runnable task) {
        listeners.stream()
                .filter(listening -> listening.isTo(listener))
                .forEach(listening -> listening.afterwards(task));
    }

    /** Waits until everybody has heard what was said so far, for one second at most. */
    public void flush() {
        CountDownLatch deaf = new CountDownLatch(listeners.size());
        listeners.forEach(listening -> listening.afterwards(deaf::countDown));
        try {
            if (!deaf.await(FLUSH_BOUND_MS, TimeUnit.MILLISECONDS)) {
                LOG.log(Level.DEBUG, "a listener of the session does not listen");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Tells that a robot was connected and taken into the team past the script, by a dialog for instance, so that a
     * saved session has it.
     *
     * @param member the robot
     * @param address where it is, as {@code add} would take it
     */
    public void joined(Member member, String address) {
        comings.joined(member, address);
    }

    /**
     * The robot at an address that has lost its link. {@code add} connects it again under its number instead of taking
     * in another one; so does whoever connects robots past the script.
     *
     * @param address as {@code add} would take it
     * @return a robot of the team; empty if none is lost there
     */
    public Optional<Member> lostAt(String address) {
        return comings.lost(address, OptionalInt.empty());
    }

    /** Says something to everybody; never waits. One lock keeps the order the same for all. */
    void say(Line.Kind kind, String text) {
        say(new Line(kind, text));
    }

    /** As {@link #say(Line.Kind, String)}, for one source of lines in the first place. */
    void say(Line.Kind kind, String text, @Nullable Object asker) {
        say(new Line(kind, text, asker));
    }

    private void say(Line line) {
        synchronized (saying) {
            log.write(line.kind().name().toLowerCase(Locale.ROOT), line.text());
            listeners.forEach(listening -> listening.tell(line));
        }
    }

    void quit() {
        quit.run();
    }

    /** How often robots were stopped; who waits compares it with what it was. */
    StopCount stops() {
        return team.stops();
    }

    /** Where robots come from and go to. */
    Comings comings() {
        return comings;
    }

    /** The behaviours that can be loaded and those that run. */
    Behaviours behaviours() {
        return behaviours;
    }

    /** What was done so far, to be replayed. */
    SessionRecord record() {
        return sessionRecord;
    }

    ParameterLog parameterLog() {
        return parameterLog;
    }

    Sampling sampling() {
        return sampling;
    }

    /** Puts what the team says into words for the session. */
    private final class TeamRelay implements TeamListener {
        @Override
        public void answered(Answer answer) {
            say(Line.Kind.ANSWER, answer.text(), answer.asker());
        }

        @Override
        public void noticed(int robot, String message) {
            say(Line.Kind.NOTICE, message);
        }

        @Override
        public void lost(Member member, String reason) {
            String hint = comings.address(member)
                    .map(address -> "; \"add " + address + "\" connects it again")
                    .orElse("");
            say(Line.Kind.NOTICE, member.number() + ": " + reason + hint);
        }

        @Override
        public void regained(Member member) {
            String where =
                    comings.address(member).map(address -> " at " + address).orElse("");
            String label = member.bot().type().label();
            say(Line.Kind.ANSWER, member.number() + ": " + label + where + " connected again");
        }

        @Override
        public void removed(Member member) {
            say(Line.Kind.ANSWER, "Bot " + member.number() + " is dead");
        }

        @Override
        public void latchChanged(boolean latched) {
            say(
                    Line.Kind.NOTICE,
                    latched
                            ? "STOP is latched; \"release\" allows motion again"
                            : "released: motion is allowed again, nothing resumes by itself");
        }
    }
}
