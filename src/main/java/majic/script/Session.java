package majic.script;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.Answer;
import majic.bot.BotFactory;
import majic.bot.Member;
import majic.bot.Team;
import majic.bot.TeamListener;
import majic.log.SessionLog;

/**
 * What everything in one running MAJIC has in common: the team, where robots come from, and what is said. Window,
 * console and every socket have a {@link MajicParser} each, on the same session. It closes nothing by itself.
 * Thread-safe.
 */
public final class Session {
    private static final Logger LOG = System.getLogger(Session.class.getName());

    private final Team team;
    private final BotFactory factory;
    private final SessionLog log;
    private final Runnable quit;
    private final List<SessionListener> listeners = new CopyOnWriteArrayList<>();
    private final Object saying = new Object();

    /**
     * A session with nobody listening yet.
     *
     * @param team the robots; its answers and notices are told to the session's listeners from now on
     * @param factory makes robots for {@code add}
     * @param log gets everything that is said
     * @param quit what {@code quit} does; must return at once
     */
    public Session(Team team, BotFactory factory, SessionLog log, Runnable quit) {
        this.team = team;
        this.factory = factory;
        this.log = log;
        this.quit = quit;
        team.addListener(new TeamRelay());
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
     * Begins to tell somebody what is said.
     *
     * @param listener who
     */
    public void addListener(SessionListener listener) {
        listeners.add(listener);
    }

    /**
     * Ends telling somebody.
     *
     * @param listener who was added
     */
    public void removeListener(SessionListener listener) {
        listeners.remove(listener);
    }

    /** Tells everybody; when this returns, everybody has heard it. One lock keeps the order the same for all. */
    void say(Line.Kind kind, String text) {
        Line line = new Line(kind, text);
        synchronized (saying) {
            log.write(kind.name().toLowerCase(Locale.ROOT), text);
            listeners.forEach(listener -> tell(listener, line));
        }
    }

    void quit() {
        quit.run();
    }

    private static void tell(SessionListener listener, Line line) {
        try {
            listener.line(line);
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "a listener of the session failed", e);
        }
    }

    /** Puts what the team says into words for the session. */
    private final class TeamRelay implements TeamListener {
        @Override
        public void answered(Answer answer) {
            say(Line.Kind.ANSWER, answer.text());
        }

        @Override
        public void noticed(int robot, String message) {
            say(Line.Kind.NOTICE, message);
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
