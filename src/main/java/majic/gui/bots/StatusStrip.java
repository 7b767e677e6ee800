package majic.gui.bots;

import java.awt.Container;
import java.awt.FontMetrics;
import java.awt.Point;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.MajicBot;
import majic.gui.acts.ActBar;
import majic.gui.kit.BotStatus;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.NumberBadge;
import majic.gui.kit.Palette;
import majic.gui.kit.StateIcon;
import majic.panel.PlotLink;
import majic.team.Member;
import majic.team.Team;
import majic.text.ErrorWords;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Shows one robot's name and make, state, owner and position in three lines, with the buttons that stop and reconnect
 * it, and its act.
 */
final class StatusStrip extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StatusStrip.class);
    private static final List<String> POSE = List.of("x", "y", "heading");

    private final transient Member member;
    private final transient Team team;
    private final JLabel condition = new JLabel();
    private final JLabel stopProblem;
    private final JLabel pose = new JLabel();
    private final ActBar act;
    private final ReconnectCountdown countdown;
    private final JLabel title;
    private final JButton reconnect = new JButton(TEXTS.get("strip.reconnect"));
    private final JButton window = new JButton(ActionIcon.WINDOW);

    /**
     * Creates a strip.
     *
     * @param move shows the robot's panel in a window of its own, or back in the main window
     */
    StatusStrip(Team team, Member member, RobotActions actions, Runnable move) {
        super(new MigLayout("insets 6 10 6 10, gap 8 2, hidemode 3", "[grow, fill][]", "[][][][][][]"));
        this.team = team;
        this.member = member;
        act = new ActBar(member, () -> actions.endAct(member));
        countdown = new ReconnectCountdown(member, actions);
        condition.setName("condition" + member.number());
        stopProblem = new NamedLabel("stopProblem" + member.number(), "");
        stopProblem.setForeground(Palette.error());
        stopProblem.setIcon(StateIcon.UNCONFIRMED);
        stopProblem.putClientProperty("FlatLaf.style", "font: bold");
        pose.setName("pose" + member.number());
        pose.setFocusable(true);
        PlotLink.install(pose, POSE, this::poseAt);
        title = new NamedLabel("title" + member.number(), "");
        title.setIcon(new NumberBadge(member.number(), 22));
        title.putClientProperty("FlatLaf.styleClass", "h4");
        JButton stopIt = new JButton(TEXTS.get("strip.stop", member.number()));
        stopIt.setToolTipText(TEXTS.get("strip.stop.tip"));
        stopIt.addActionListener(event -> actions.stop(member));
        reconnect.setName("reconnect" + member.number());
        reconnect.addActionListener(event -> reconnect(actions));
        window.setName("window" + member.number());
        window.addActionListener(event -> move.run());
        setDocked(true);
        add(title, "wmin 0");
        add(reconnect, "split 3");
        add(stopIt);
        add(window, "wrap");
        add(condition, "spanx, wmin 0, wrap");
        add(countdown, "spanx, wmin 0, wrap");
        add(stopProblem, "spanx, wmin 0, wrap");
        add(pose, "spanx, wmin 0, wrap");
        add(act, "spanx, growx, wmin 0, gaptop 4");
        update();
    }

    /** Adapts the alarm colour to the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (stopProblem != null) {
            stopProblem.setForeground(Palette.error());
        }
    }

    /** Returns the robot's name and make. */
    static String title(Member member) {
        return Member.label(member.name(), member.bot().type().make());
    }

    /** Shows the robot's published state. */
    void update() {
        title.setText(title(member));
        act.update();
        countdown.update();
        String owner = act.isVisible() ? "" : BotStatus.user(member);
        showStop();
        condition.setIcon(StateIcon.of(member.bot()));
        condition.setText(BotStatus.condition(member) + (owner.isEmpty() ? "" : ", " + owner));
        pose.setText(BotStatus.pose(member));
        pose.setEnabled(member.bot().isConnected());
        reconnect.setVisible(member.bot().connection() == MajicBot.Connection.LOST);
    }

    /** Returns the parameter that the pose's text shows at a point: three parts with blanks between them. */
    private List<String> poseAt(Point point) {
        FontMetrics metrics = pose.getFontMetrics(pose.getFont());
        String[] parts = pose.getText().split("(?<=   )");
        int left = 0;
        for (int index = 0; index < parts.length && parts.length == POSE.size(); index++) {
            left += metrics.stringWidth(parts[index]);
            if (point.x < left) {
                return List.of(POSE.get(index));
            }
        }
        return List.of();
    }

    private void showStop() {
        Optional<String> problem = team.stopStatus().problem(member.number());
        stopProblem.setText(TEXTS.get("strip.unconfirmed", ErrorWords.of(problem.orElse(""))));
        stopProblem.setToolTipText(stopProblem.getText());
        stopProblem.setVisible(problem.isPresent());
    }

    /** Shows whether the panel is in the main window. */
    void setDocked(boolean docked) {
        String text = TEXTS.get(docked ? "strip.undock" : "strip.dock");
        window.setToolTipText(text);
        window.getAccessibleContext().setAccessibleName(text);
    }

    private void reconnect(RobotActions actions) {
        reconnect.setEnabled(false);
        leaveFocus();
        actions.reconnect(member, () -> reconnect.setEnabled(true));
    }

    /**
     * Moves the focus to the window's default component when the focused button is hidden; the neighbouring button
     * takes no typed text.
     */
    private void leaveFocus() {
        Container window = getFocusCycleRootAncestor();
        window.getFocusTraversalPolicy().getDefaultComponent(window).requestFocusInWindow();
    }
}
