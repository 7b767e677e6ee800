package majic.gui.start;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.Timer;
import majic.bot.BotException;
import majic.environment.Settings;
import majic.gui.add.RecentRobots;
import majic.gui.kit.EventThread;
import majic.script.SavedTeam;
import majic.script.Session;
import majic.team.Member;
import majic.team.TeamListener;
import majic.text.ErrorWords;
import majic.text.LateLogger;
import majic.text.Texts;

/**
 * Keeps the team in the settings, so that it can be opened again after the next start: as it was when a robot was added
 * last, or when the program ended. Keeps the addresses of its robots too, which Add Bot offers. Must be used on the
 * event dispatch thread unless stated otherwise.
 */
public final class LastTeam implements TeamListener {
    private static final Logger LOG = LateLogger.of(LastTeam.class);
    private static final Texts TEXTS = Texts.of(LastTeam.class);
    private static final String KEY = "team.last";
    private static final String DAMAGED = KEY + ".damaged";
    private static final int COLLECT_MS = 1000;

    private final Session session;
    private final Settings settings;
    private final RecentRobots recent;
    private final Timer soon = new Timer(COLLECT_MS, event -> EventThread.background("keeping the team", snapshot()));
    private Consumer<List<String>> shown = names -> {};

    public LastTeam(Session session, Settings settings) {
        this.session = session;
        this.settings = settings;
        this.recent = new RecentRobots(settings);
        soon.setRepeats(false);
    }

    /** Sets the receiver of the names of the robots; empty while there was no team yet. */
    void onChange(Consumer<List<String>> listener) {
        shown = listener;
    }

    /** Reads the team in the background, and shows it. */
    void read() {
        EventThread.background("reading the last team", () -> {
            List<String> names =
                    saved().map(team -> team.names(session.factory())).orElse(List.of());
            EventThread.later(() -> shown.accept(names));
        });
    }

    /**
     * Returns the team that was used last. A damaged one is reported, and kept under another key, so that the next team
     * does not replace it. Callable from any thread; may block.
     *
     * @return empty if there was none, or it was damaged
     */
    public synchronized Optional<SavedTeam> saved() {
        String script = settings.get(KEY).orElse("");
        try {
            return Optional.of(SavedTeam.parse(script)).filter(team -> !team.isEmpty());
        } catch (BotException e) {
            keepDamaged(script);
            String text = TEXTS.get("lastTeam.damaged", ErrorWords.of(String.valueOf(e.getMessage())), DAMAGED);
            EventThread.later(() -> session.alarm(text));
            return Optional.empty();
        }
    }

    private void keepDamaged(String script) {
        try {
            settings.put(DAMAGED, script);
            settings.put(KEY, "");
        } catch (BotException e) {
            LOG.log(Level.WARNING, "the damaged team is not kept after the end", e);
        }
    }

    @Override
    public void added(Member member) {
        keepSoon();
    }

    @Override
    public void renamed(Member member) {
        keepSoon();
    }

    /** Keeps the team in a second, when what was submitted has been done. */
    public void keepSoon() {
        soon.restart();
    }

    private void keepAddresses(List<String> addresses) {
        try {
            recent.keep(addresses);
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "the addresses are not kept after the end", e);
        }
    }

    /**
     * Takes note of the team as it is now. Callable from any thread; does not block.
     *
     * @return keeps it, unless it is empty; may block
     */
    public Runnable snapshot() {
        String script = session.teamScript();
        List<String> addresses = session.team().members().stream()
                .flatMap(member -> session.address(member).stream())
                .toList();
        return () -> {
            if (!addresses.isEmpty()) {
                keepAddresses(addresses);
                keep(script);
            }
        };
    }

    private void keep(String script) {
        try {
            if (!settings.get(KEY).equals(Optional.of(script))) {
                settings.put(KEY, script);
            }
            read();
        } catch (BotException e) {
            LOG.log(Level.DEBUG, "the team is not kept after the end", e);
        }
    }
}
