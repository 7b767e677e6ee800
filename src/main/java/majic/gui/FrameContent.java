package majic.gui;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import majic.gui.command.CommandPane;
import majic.gui.kit.EventThreadTeamListener;
import majic.team.Team;

/** Places the parts of the window: buttons and STOP, the team, messages with unconfirmed stops, command line. */
final class FrameContent extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JSplitPane all;
    private final TeamPane teamPane;

    /**
     * Creates the content.
     *
     * @param buttons made by {@link FrameToolbar#button}, in their order
     * @param stopAll stops all robots
     */
    FrameContent(Team team, List<JButton> buttons, Runnable stopAll, TeamPane teamPane, CommandPane commands) {
        super(new BorderLayout());
        this.teamPane = teamPane;
        StopPanel stop = new StopPanel(team, stopAll);
        team.addListener(new EventThreadTeamListener(stop));
        StopAlarm alarm = new StopAlarm(team, commands.messages());
        team.addListener(new EventThreadTeamListener(alarm));
        all = new JSplitPane(JSplitPane.VERTICAL_SPLIT, teamPane, commands);
        all.setResizeWeight(0.75);
        JPanel belowButtons = new JPanel(new BorderLayout(0, 6));
        belowButtons.setBorder(BorderFactory.createEmptyBorder(0, 8, 8, 8));
        belowButtons.add(all, BorderLayout.CENTER);
        add(new FrameToolbar(buttons, stop), BorderLayout.NORTH);
        add(belowButtons, BorderLayout.CENTER);
    }

    /** Returns the split panes whose dividers are remembered, always in the same order. */
    List<JSplitPane> splits() {
        return List.of(teamPane, all);
    }
}
