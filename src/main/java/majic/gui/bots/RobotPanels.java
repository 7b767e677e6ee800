package majic.gui.bots;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import majic.gui.drive.DrivePad;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.RobotSelection;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.NumberList;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * The panel of the selected robot, or those of two side by side, above the pad that drives the selected robots. A panel
 * can be moved into a window of its own. Without robots, another component is shown.
 */
public final class RobotPanels extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RobotPanels.class);

    /** The property that is true while two panels are shown side by side. */
    public static final String COMPARING = "comparing";

    private static final String EMPTY = "empty";
    private static final String ROBOTS = "robots";

    /** How many panels are shown side by side. */
    private static final int COMPARED = 2;

    private final transient Team team;
    private final transient RobotSelection selection;
    private final transient RobotActions actions;
    private final CardLayout cards = new CardLayout();
    private final JPanel row = new JPanel();
    private final JLabel notice = new NamedLabel("panelNotice", "");
    private @Nullable DrivePad pad;
    private final transient Map<Member, BotPanel> panels = new HashMap<>();
    private final transient Map<Member, PanelWindow> windows = new HashMap<>();
    private boolean comparing;

    /**
     * Creates panels for the robots that are in the team already; panels for later ones are added by events.
     *
     * @param whenEmpty shown while there is no robot
     */
    public RobotPanels(Team team, RobotSelection selection, RobotActions actions, JComponent whenEmpty) {
        this.team = team;
        this.selection = selection;
        this.actions = actions;
        setLayout(cards);
        setName("robotPanels");
        add(whenEmpty, EMPTY);
        selection.addListener(this::showSelection);
        team.members().forEach(this::added);
    }

    /** Creates what surrounds the panels; the program starts without a robot, and sooner without this. */
    private void placePanels() {
        DrivePad made = new DrivePad("", actions::showError);
        notice.setHorizontalAlignment(SwingConstants.CENTER);
        notice.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        row.setLayout(new MigLayout("insets 0, gap 0, hidemode 3, fill", "", "[fill]"));
        JPanel robots = new JPanel(new BorderLayout());
        robots.add(notice, BorderLayout.NORTH);
        robots.add(row, BorderLayout.CENTER);
        robots.add(made, BorderLayout.SOUTH);
        add(robots, ROBOTS);
        pad = made;
    }

    /** Adds the panel, in the order of the numbers; it is visible while its robot is selected. */
    @Override
    public void added(Member member) {
        if (team.members().contains(member) && !panels.containsKey(member)) {
            if (pad == null) {
                placePanels();
            }
            panels.put(member, new BotPanel(team, member, actions, this::move, () -> changed(member)));
            dock(member);
            cards.show(this, ROBOTS);
        }
    }

    @Override
    public void removed(Member member) {
        BotPanel panel = panels.remove(member);
        if (panel == null) {
            return;
        }
        panel.close();
        row.remove(panel);
        Optional.ofNullable(windows.remove(member)).ifPresent(PanelWindow::dispose);
        if (panels.isEmpty()) {
            cards.show(this, EMPTY);
        }
        showSelection();
    }

    /** Shows the panel of a robot in a window of its own; if it is in one already, brings that to the front. */
    public void openWindow(Member member) {
        BotPanel panel = panels.get(member);
        if (panel == null) {
            return;
        }
        PanelWindow window = windows.get(member);
        if (window == null) {
            panel.setVisible(true);
            panel.setDocked(false);
            window = new PanelWindow(panel, actions, SwingUtilities.getWindowAncestor(this), () -> dock(member));
            windows.put(member, window);
            window.setVisible(true);
            showSelection();
        }
        window.toFront();
    }

    private void move(Member member) {
        if (windows.containsKey(member)) {
            dock(member);
        } else {
            openWindow(member);
        }
    }

    /** Puts the panel of a robot into this component, and closes its window if it has one. */
    private void dock(Member member) {
        BotPanel panel = panels.get(member);
        Optional.ofNullable(windows.remove(member)).ifPresent(PanelWindow::dispose);
        if (panel != null) {
            panel.setDocked(true);
            row.add(panel, "grow, push, sizegroup panels, wmin 0, hmin 0", place(member));
        }
        showSelection();
    }

    /** Returns the place of a robot's panel in the row, which is in the order of the numbers. */
    private int place(Member member) {
        return (int) Stream.of(row.getComponents())
                .map(BotPanel.class::cast)
                .filter(other -> other.member().number() < member.number())
                .count();
    }

    /** Closes the windows of the robots; to be called when the main window closes. */
    public void close() {
        windows.values().forEach(PanelWindow::dispose);
        windows.clear();
    }

    /** Gives the focus to the pad that drives the selected robots; has no effect while there is no robot. */
    public void focusPad() {
        if (pad != null) {
            pad.requestFocusInWindow();
        }
    }

    private void showSelection() {
        List<Member> chosen = selection.members();
        List<Member> docked = chosen.stream()
                .filter(member -> panels.containsKey(member) && !windows.containsKey(member))
                .toList();
        List<Member> shown = docked.subList(0, Math.min(docked.size(), chosen.size() > COMPARED ? 1 : COMPARED));
        panels.forEach((member, panel) -> {
            if (!windows.containsKey(member)) {
                panel.setVisible(shown.contains(member));
            }
        });
        notice.setText(notice(chosen, shown));
        notice.setVisible(!notice.getText().isEmpty());
        if (pad != null) {
            pad.choose(chosen);
        }
        revalidate();
        repaint();
        boolean before = comparing;
        comparing = shown.size() == COMPARED;
        firePropertyChange(COMPARING, before, comparing);
    }

    /** Returns whether two panels are shown side by side. */
    public boolean isComparing() {
        return comparing;
    }

    private String notice(List<Member> chosen, List<Member> shown) {
        if (chosen.isEmpty()) {
            return TEXTS.get("panels.noneSelected");
        }
        if (chosen.size() > COMPARED) {
            return TEXTS.get("panels.manySelected", numbers(chosen));
        }
        List<Member> elsewhere =
                chosen.stream().filter(member -> !shown.contains(member)).toList();
        return elsewhere.isEmpty() ? "" : TEXTS.get("panels.elsewhere", numbers(elsewhere));
    }

    private static String numbers(List<Member> members) {
        return NumberList.of(members.stream().map(Member::number).toList());
    }

    private void changed(Member member) {
        if (pad != null && selection.contains(member)) {
            pad.update();
        }
        Optional.ofNullable(windows.get(member)).ifPresent(PanelWindow::update);
    }

    @Override
    public void renamed(Member member) {
        ownerChanged(member);
    }

    @Override
    public void ownerChanged(Member member) {
        Optional.ofNullable(panels.get(member)).ifPresent(BotPanel::changed);
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        panels.values().forEach(BotPanel::changed);
    }

    @Override
    public void latchChanged(boolean latched) {
        panels.values().forEach(BotPanel::changed);
    }
}
