package majic.panel;

import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JPanel;
import javax.swing.Timer;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;

/**
 * A panel that shows one robot. News of the robot only leave a mark, on whatever thread they come; a timer of the event
 * dispatch thread looks for the mark ten times a second while the panel is in sight, and only then: not on a hidden tab,
 * not in an iconified window. For the event dispatch thread, except {@link #heard}.
 */
public abstract class NewsPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int REFRESH_MS = 100;

    /** A robot that says nothing is shown anew this often, for silence is news as well. */
    private static final int TICKS_OF_SILENCE = 10;

    private final transient MajicBot bot;
    private final transient AtomicBoolean news = new AtomicBoolean(true);
    private final transient BotListener listener = new News();
    private final Timer timer = new Timer(REFRESH_MS, tick -> tick());
    private final transient Sight sight;
    private int quietTicks;

    /**
     * Makes an empty panel; it hears of the robot as long as it is part of a window.
     *
     * @param bot which one to listen to
     */
    protected NewsPanel(MajicBot bot) {
        super(null);
        this.bot = bot;
        this.sight = new Sight(this, this::look);
    }

    private void look(boolean seen) {
        runTimer(seen);
        inSight(seen);
    }

    /** Shows what the robot said last. Called on the event dispatch thread, at most ten times a second; must not wait. */
    protected abstract void refresh();

    /**
     * Takes note of what must not be missed between two refreshes. Called on the driver's own threads while the panel is
     * part of a window, seen or not; must be quick and touch nothing of Swing.
     *
     * @param state what the robot shares with all robots
     */
    protected void heard(BotState state) {}

    /**
     * Begins or ends what is only worth doing while somebody looks. Called on the event dispatch thread; must not wait.
     *
     * @param seen whether the panel has come into sight, or is gone from it
     */
    protected void inSight(boolean seen) {}

    /** Shows what the robot said last if it said something since; for a panel that has just been made. */
    public final void refreshOnNews() {
        if (news.getAndSet(false)) {
            quietTicks = 0;
            refresh();
        }
    }

    private void tick() {
        quietTicks++;
        if (quietTicks >= TICKS_OF_SILENCE) {
            news.set(true);
        }
        refreshOnNews();
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(listener);
        news.set(true);
    }

    @Override
    public void removeNotify() {
        sight.end();
        bot.removeListener(listener);
        super.removeNotify();
    }

    private void runTimer(boolean showing) {
        if (showing) {
            refreshOnNews();
            timer.start();
        } else {
            timer.stop();
        }
    }

    /** Marks that there is something to show; called on the driver's threads. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot changed, BotState state) {
            heard(state);
            news.set(true);
        }

        @Override
        public void connectionChanged(MajicBot changed, MajicBot.Connection connection) {
            news.set(true);
        }
    }
}
