package majic.panel;

import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JPanel;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Reading;
import majic.text.Texts;
import majic.time.WaitPolicy;

/**
 * A panel that shows one robot. An event of the robot only sets a flag, on whatever thread it arrives; the event
 * dispatch thread checks the flag ten times a second ({@link RefreshTicks}) while the panel is visible, and only then:
 * not on a hidden tab, not in an iconified window. Must be used on the event dispatch thread, except
 * {@link #stateReceived}.
 */
public abstract class RefreshingPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(RefreshingPanel.class);

    /**
     * Number of timer ticks without an event after which the panel is refreshed anyway, so that a missing report is
     * shown too.
     */
    private static final int TICKS_WITHOUT_EVENT = 10;

    private final transient MajicBot bot;
    private final transient AtomicBoolean hasChanged = new AtomicBoolean(true);
    private final transient BotListener listener = new ChangeListener();
    private final transient Runnable tick = this::tick;
    private final transient VisibilityWatch visibility;
    private int quietTicks;

    /**
     * Creates an empty panel; it listens to the robot while it is part of a window.
     *
     * @param bot the robot to listen to
     */
    protected RefreshingPanel(MajicBot bot) {
        super(null);
        this.bot = bot;
        this.visibility = new VisibilityWatch(this, this::visible);
    }

    private void visible(boolean seen) {
        refreshAtTicks(seen);
        visibilityChanged(seen);
    }

    /**
     * Shows the robot's last reported state. Called on the event dispatch thread, at most ten times a second; must not
     * block, so a value that the robot would have to be asked for is unknown.
     */
    protected abstract void refresh();

    /**
     * Records events that must not be missed between two refreshes. Called on the driver's own threads while the panel
     * is part of a window, visible or not; must be quick and must not use Swing.
     *
     * @param state the part of the state that all robots have
     */
    protected void stateReceived(BotState state) {}

    /**
     * Starts or ends work that is only useful while the panel is visible. Called on the event dispatch thread; must not
     * block.
     *
     * @param seen whether the panel has become visible; false when it is hidden
     */
    protected void visibilityChanged(boolean seen) {}

    /**
     * Returns whether the robot's reports may be shown as present values, by the rule of {@link Reading}; waits for
     * nothing.
     *
     * @return false without a connection, and while the robot is silent for too long
     */
    protected final boolean isCurrent() {
        return WaitPolicy.without(
                () -> bot.isConnected() && bot.reading("speed").isCurrent());
    }

    /**
     * Returns how old the shown values are while there is no connection, for a banner: they look like current ones
     * otherwise.
     *
     * @return a sentence; empty while the robot is connected, and before its first report
     */
    protected final String staleness() {
        BotState state = bot.state();
        if (bot.isConnected() || state.equals(BotState.UNKNOWN)) {
            return "";
        }
        return TEXTS.get("old", ReadingText.age(bot.time().secondsSince(state.atNanos())));
    }

    /** Refreshes if the robot has reported anything since the last refresh; for a panel that has just been created. */
    public final void refreshIfChanged() {
        if (hasChanged.getAndSet(false)) {
            quietTicks = 0;
            WaitPolicy.without(this::refresh);
        }
    }

    private void tick() {
        quietTicks++;
        if (quietTicks >= TICKS_WITHOUT_EVENT) {
            hasChanged.set(true);
        }
        refreshIfChanged();
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(listener);
        hasChanged.set(true);
    }

    @Override
    public void removeNotify() {
        visibility.end();
        bot.removeListener(listener);
        super.removeNotify();
    }

    private void refreshAtTicks(boolean showing) {
        if (showing) {
            refreshIfChanged();
            RefreshTicks.add(tick);
        } else {
            RefreshTicks.remove(tick);
        }
    }

    /** Marks that there is something to show; called on the driver's threads. */
    private final class ChangeListener implements BotListener {
        @Override
        public void stateChanged(MajicBot source, BotState state) {
            stateReceived(state);
            hasChanged.set(true);
        }

        @Override
        public void connectionChanged(MajicBot source, MajicBot.Connection connection) {
            hasChanged.set(true);
        }
    }
}
