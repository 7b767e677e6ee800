package majic.gui.bots;

import java.awt.Container;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.gui.acts.ActBar;
import majic.gui.kit.BotStatus;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.gui.kit.Palette;
import majic.gui.kit.PlainLabel;
import majic.gui.kit.StateIcon;
import majic.team.Member;
import majic.team.Team;
import net.miginfocom.swing.MigLayout;

/**
 * Shows one robot's make, state, owner and position in three lines, with the buttons that stop and reconnect it, and
 * its act.
 */
final class StatusStrip extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Member member;
    private final transient CommandChannel channel;
    private final transient Team team;
    private final JLabel condition = new JLabel();
    private final JLabel stopProblem;
    private final JLabel pose = new JLabel();
    private final ActBar act;
    private final JButton reconnect = new JButton("Reconnect");

    StatusStrip(Team team, Member member, CommandChannel channel) {
        super(new MigLayout("insets 6 10 6 10, gap 8 2, hidemode 3", "[grow, fill][][]", "[][][][][]"));
        this.team = team;
        this.member = member;
        this.channel = channel;
        act = new ActBar(member, () -> channel.submit(member.number() + " act off"));
        condition.setName("condition" + member.number());
        stopProblem = new PlainLabel("stopProblem" + member.number(), "");
        stopProblem.setForeground(Palette.error());
        stopProblem.setIcon(StateIcon.UNCONFIRMED);
        stopProblem.putClientProperty("FlatLaf.style", "font: bold");
        pose.setName("pose" + member.number());
        JLabel title = new JLabel(member.number() + "  " + member.bot().type().make());
        title.putClientProperty("FlatLaf.styleClass", "h4");
        JButton stopIt = new JButton("Stop " + member.number());
        stopIt.setToolTipText("Stop this robot alone, and whatever drives it");
        stopIt.addActionListener(event -> team.stop(List.of(member), null));
        reconnect.setName("reconnect" + member.number());
        reconnect.addActionListener(event -> reconnect());
        add(title, "wmin 0");
        add(reconnect);
        add(stopIt, "wrap");
        add(condition, "spanx 3, wmin 0, wrap");
        add(stopProblem, "spanx 3, wmin 0, wrap");
        add(pose, "spanx 3, wmin 0, wrap");
        add(act, "spanx 3, growx, wmin 0, gaptop 4");
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

    /** Shows the robot's published state. */
    void update() {
        act.update();
        String owner = act.isVisible() ? "" : BotStatus.owner(member);
        showStop();
        condition.setIcon(StateIcon.of(member.bot()));
        condition.setText(BotStatus.condition(member) + (owner.isEmpty() ? "" : ", " + owner));
        pose.setText(BotStatus.pose(member));
        reconnect.setVisible(member.bot().connection() == MajicBot.Connection.LOST);
    }

    private void showStop() {
        Optional<String> problem = team.stopStatus().problem(member.number());
        stopProblem.setText("Stop not confirmed, may still move: " + problem.orElse(""));
        stopProblem.setToolTipText(stopProblem.getText());
        stopProblem.setVisible(problem.isPresent());
    }

    private void reconnect() {
        reconnect.setEnabled(false);
        leaveFocus();
        EventThread.background("reconnecting robot " + member.number(), () -> {
            try {
                member.bot().connect();
            } catch (BotException e) {
                String problem = String.valueOf(e.getMessage());
                channel.showError(member.number() + ": " + member.bot().type().adviceAfter(problem));
            } finally {
                EventThread.later(() -> reconnect.setEnabled(true));
            }
        });
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
