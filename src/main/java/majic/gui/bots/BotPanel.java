package majic.gui.bots;

import java.awt.BorderLayout;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import majic.gui.plot.PlottedPanel;
import majic.panel.CommandHost;
import majic.team.Member;
import majic.team.Team;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/** Shows one robot large: its status strip, and the display that its class provides. */
final class BotPanel extends PlottedPanel implements CommandHost {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(BotPanel.class);
    private static final Logger LOG = System.getLogger(BotPanel.class.getName());

    private final transient Member member;
    private final transient RobotActions actions;
    private final StatusStrip strip;
    private final transient MemberRefresh refresh;
    private boolean hasDisplay;

    /**
     * Creates a panel for a robot, not visible yet; it listens to the robot until {@link #close()}.
     *
     * @param move shows the panel in a window of its own, or back in the main window
     * @param changed runs, at most ten times a second, after the robot's state has changed
     */
    BotPanel(Team team, Member member, RobotActions actions, Consumer<Member> move, Runnable changed) {
        super(new BorderLayout(), actions.plots(), member.number(), member.bot()::parameters);
        this.member = member;
        this.actions = actions;
        setName("bot" + member.number());
        strip = new StatusStrip(team, member, actions, () -> move.accept(member));
        add(strip, BorderLayout.NORTH);
        setVisible(false);
        refresh = new MemberRefresh(member, () -> {
            if (isVisible()) {
                strip.update();
            }
            changed.run();
        });
    }

    Member member() {
        return member;
    }

    /** Schedules an update; callable from any thread. */
    void changed() {
        refresh.changed();
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

    /** Where the panel is decides on its size: what it shows lays out nothing else. */
    @Override
    public boolean isValidateRoot() {
        return true;
    }

    @Override
    public void submitCommand(String command) {
        actions.submit(member, command);
    }

    /** Removes the listener. */
    void close() {
        refresh.close();
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
     * Creates the robot's own display; null if that fails, since a robot's class may come from a plug-in. The panel is
     * shown without it then.
     */
    private @Nullable JComponent ownDisplay() {
        try {
            return member.bot().display();
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "the display of robot " + member.number() + " could not be made", e);
            return null;
        }
    }
}
