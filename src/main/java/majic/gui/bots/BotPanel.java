package majic.gui.bots;

import java.awt.BorderLayout;
import java.awt.datatransfer.Transferable;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.panel.PlotHost;
import majic.panel.RefreshTicks;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Shows one robot large: its status strip, and the display that its class provides. */
final class BotPanel extends JPanel implements PlotHost {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(BotPanel.class);
    private static final Logger LOG = System.getLogger(BotPanel.class.getName());

    private final transient Member member;
    private final transient RobotActions actions;
    private final StatusStrip strip;
    private final transient Runnable update;
    private final transient BotListener listener = new ChangeListener();
    private boolean hasDisplay;

    /**
     * Creates a panel for a robot, not visible yet; it listens to the robot until {@link #close()}.
     *
     * @param move shows the panel in a window of its own, or back in the main window
     * @param changed runs, at most ten times a second, after the robot's state has changed
     */
    BotPanel(Team team, Member member, RobotActions actions, Consumer<Member> move, Runnable changed) {
        super(new BorderLayout());
        this.member = member;
        this.actions = actions;
        setName("bot" + member.number());
        strip = new StatusStrip(team, member, actions, () -> move.accept(member));
        update = () -> {
            if (isVisible()) {
                strip.update();
            }
            changed.run();
        };
        add(strip, BorderLayout.NORTH);
        setVisible(false);
        member.bot().addListener(listener);
    }

    @Override
    public boolean canPlot(String parameter) {
        return actions.canPlot(member, parameter);
    }

    @Override
    public void plot(List<String> parameters, boolean add) {
        actions.plot(member, parameters, add);
    }

    @Override
    public Transferable dragged(List<String> parameters) {
        return actions.dragged(member, parameters);
    }

    Member member() {
        return member;
    }

    /** Schedules an update; callable from any thread. */
    void changed() {
        RefreshTicks.once(update);
    }

    /** Shows whether the panel is in a window of its own. */
    void setDocked(boolean docked) {
        strip.setDocked(docked);
    }

    /** Makes the display when the panel becomes visible first, since most panels of a large team never do. */
    @Override
    public void setVisible(boolean visible) {
        if (visible && !hasDisplay) {
            hasDisplay = true;
            add(display(), BorderLayout.CENTER);
        }
        if (visible && !isVisible()) {
            strip.update();
        }
        super.setVisible(visible);
    }

    /** Removes the listener. */
    void close() {
        member.bot().removeListener(listener);
    }

    private JComponent display() {
        JComponent display = ownDisplay();
        if (display == null) {
            JLabel none = new JLabel(TEXTS.get("panel.noDisplay"), SwingConstants.CENTER);
            none.setName("noDisplay");
            none.setEnabled(false);
            return none;
        }
        JScrollPane scroll = new JScrollPane(new DisplayView(display));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        return scroll;
    }

    /**
     * Creates the robot's own display; null if that fails, since a robot's class may come from a plug-in. The panel
     * is shown without it then.
     */
    private @Nullable JComponent ownDisplay() {
        try {
            return member.bot().display();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "the display of robot " + member.number() + " could not be made", e);
            return null;
        }
    }

    /** Updates the strip at a limited rate, however fast the robot reports. */
    private final class ChangeListener implements BotListener {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            RefreshTicks.once(update);
        }

        @Override
        public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
            RefreshTicks.once(update);
        }
    }
}
