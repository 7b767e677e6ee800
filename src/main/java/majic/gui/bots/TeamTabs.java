package majic.gui.bots;

import java.awt.Component;
import java.awt.Point;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import majic.gui.drive.DrivePad;
import majic.gui.drive.GuardChoice;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.RobotSelection;
import majic.team.Member;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.NumberList;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * The team: a tab for each robot, the pane of the selected robot, or those of two side by side, and below them the pad
 * that drives the selected robots. The selected tab is that of the first selected robot. A pane can be moved into a
 * window of its own.
 */
public final class TeamTabs extends RobotTabs implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(TeamTabs.class);

    /** The property that is true while two panes are shown side by side. */
    public static final String COMPARING = "comparing";

    /** How many panes are shown side by side. */
    private static final int COMPARED = 2;

    /** How often the times on the tabs are brought up to date without a report of the robot. */
    private static final int TICK_MS = 500;

    private final transient Team team;
    private final transient RobotSelection selection;
    private final transient RobotActions actions;
    private final transient GuardChoice guard;
    private final transient SummaryReader reader;
    private final transient Map<RobotTab, MemberTab> members = new LinkedHashMap<>();
    private final transient Map<Member, BotPanel> panels = new HashMap<>();
    private final transient Map<Member, PanelWindow> windows = new HashMap<>();
    private final JLabel notice = new NamedLabel("panelNotice", "");
    private final Timer tick = new Timer(TICK_MS, event -> members.values().forEach(MemberTab::update));
    private @Nullable DrivePad pad;
    private boolean comparing;

    /**
     * Creates tabs for the robots that are in the team already; tabs for later ones are added by events.
     *
     * @param guard whether robots that are driven by hand are guarded
     */
    public TeamTabs(Team team, RobotSelection selection, RobotActions actions, GuardChoice guard) {
        super("mainPane");
        HelpTopic.set(this, "selecting-robots");
        this.team = team;
        this.selection = selection;
        this.actions = actions;
        this.guard = guard;
        reader = new SummaryReader(team);
        notice.setHorizontalAlignment(SwingConstants.CENTER);
        notice.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        selection.addListener(this::follow);
        team.members().forEach(this::added);
    }

    @Override
    public void addNotify() {
        super.addNotify();
        reader.start();
        tick.start();
    }

    @Override
    public void removeNotify() {
        tick.stop();
        reader.close();
        super.removeNotify();
    }

    /** Adds a tab; selects the robot only if it is the only one, because a selected one may be driven at the moment. */
    @Override
    public void added(Member member) {
        if (!team.members().contains(member) || panels.containsKey(member)) {
            return;
        }
        if (pad == null) {
            pad = new DrivePad("", guard, actions::showError);
            setFooter(notice, pad);
        }
        MemberTab added = new MemberTab(team, member, actions, reader);
        BotPanel panel = new BotPanel(team, member, actions, this::move, () -> changed(member));
        members.put(added.tab(), added);
        panels.put(member, panel);
        insert(added.tab(), panel);
    }

    @Override
    public void removed(Member member) {
        BotPanel panel = panels.remove(member);
        MemberTab tab = tab(member).orElse(null);
        if (panel == null || tab == null) {
            return;
        }
        selection.remove(member);
        tab.close();
        panel.close();
        remove(tab.tab());
        members.remove(tab.tab());
        Optional.ofNullable(windows.remove(member)).ifPresent(PanelWindow::dispose);
        follow();
    }

    private Optional<MemberTab> tab(Member member) {
        return members.values().stream().filter(tab -> tab.member() == member).findFirst();
    }

    private Member member(RobotTab tab) {
        return members.get(tab).member();
    }

    private int indexOf(Member member) {
        return tab(member).map(tab -> tabs().indexOf(tab.tab())).orElse(-1);
    }

    @Override
    void choose(RobotTab tab) {
        selection.select(member(tab));
    }

    @Override
    void toggle(RobotTab tab) {
        selection.toggle(member(tab));
    }

    @Override
    void chooseAll() {
        selection.set(tabs().stream().map(this::member).toList());
    }

    @Override
    boolean isChosen(RobotTab tab) {
        return selection.contains(member(tab));
    }

    /** Selects the robot of a tab that was selected without the selection of robots. */
    @Override
    void selectedIndexChanged() {
        int index = getSelectedIndex();
        if (index >= 0 && !selection.first().equals(Optional.of(member(tabs().get(index))))) {
            selection.select(member(tabs().get(index)));
        } else {
            showSelected();
        }
    }

    /** Shows the tabs and the panes of the selected robots. */
    private void follow() {
        setSelectedIndex(selection.first().map(this::indexOf).orElse(-1));
        showSelected();
        List<Member> chosen = selection.members();
        notice.setText(notice(chosen));
        notice.setToolTipText(notice.getText());
        notice.setVisible(!notice.getText().isEmpty());
        if (pad != null) {
            pad.choose(chosen);
        }
        boolean before = comparing;
        comparing = chosen.size() == COMPARED;
        firePropertyChange(COMPARING, before, comparing);
    }

    @Override
    boolean isShown(int index) {
        List<Member> chosen = selection.members();
        return index == getSelectedIndex() || chosen.size() == COMPARED && index == indexOf(chosen.get(COMPARED - 1));
    }

    private static String notice(List<Member> chosen) {
        if (chosen.isEmpty()) {
            return TEXTS.get("tabs.noneSelected");
        }
        return chosen.size() > COMPARED
                ? TEXTS.get(
                        "tabs.manySelected",
                        NumberList.of(chosen.stream().map(Member::number).toList()))
                : "";
    }

    /** Returns whether two panes are shown side by side. */
    public boolean isComparing() {
        return comparing;
    }

    @Override
    void rename(RobotTab tab) {
        actions.rename(member(tab), this);
    }

    @Override
    void showMenu(RobotTab tab, Component on, int x, int y) {
        showMenu(member(tab), on, x, y);
    }

    /**
     * Opens the context menu of a robot.
     *
     * @param on the component that was clicked, and the place in it
     */
    public void showMenu(Member member, Component on, int x, int y) {
        new RobotMenu(member, actions, this::openWindow).show(on, x, y);
    }

    private void openWindow(Member member) {
        BotPanel panel = panels.get(member);
        if (panel == null) {
            return;
        }
        PanelWindow window = windows.get(member);
        if (window == null) {
            JLabel elsewhere = new NamedLabel("elsewhere" + member.number(), TEXTS.get("tabs.elsewhere"));
            elsewhere.setHorizontalAlignment(SwingConstants.CENTER);
            setComponentAt(indexOf(member), elsewhere);
            panel.setVisible(true);
            panel.setDocked(false);
            Point place = columns().placeOfPanes();
            SwingUtilities.convertPointToScreen(place, this);
            window = new PanelWindow(
                    panel, actions, guard, SwingUtilities.getWindowAncestor(this), place, () -> dock(member));
            windows.put(member, window);
            window.setVisible(true);
            showSelected();
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

    /** Puts the pane of a robot back beside its tab, and closes its window. */
    private void dock(Member member) {
        Optional.ofNullable(windows.remove(member)).ifPresent(PanelWindow::dispose);
        BotPanel panel = panels.get(member);
        if (panel != null) {
            panel.setDocked(true);
            setComponentAt(indexOf(member), panel);
            showSelected();
        }
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
        tab(member).ifPresent(MemberTab::changed);
        Optional.ofNullable(panels.get(member)).ifPresent(BotPanel::changed);
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        members.values().forEach(MemberTab::changed);
        panels.values().forEach(BotPanel::changed);
    }

    @Override
    public void latchChanged(boolean latched) {
        panels.values().forEach(BotPanel::changed);
    }
}
