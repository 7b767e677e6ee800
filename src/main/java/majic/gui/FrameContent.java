package majic.gui;

import java.util.List;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import majic.gui.command.CommandPane;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.IconAction;
import majic.team.Team;
import net.miginfocom.swing.MigLayout;

/** Places the parts of the window: buttons and STOP, unconfirmed stops, the team, messages and command line. */
final class FrameContent extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient List<IconAction> buttons;
    private final JSplitPane all;
    private final TeamPane teamPane;

    /**
     * Creates the content.
     *
     * @param buttons the actions of the buttons, in their order
     * @param stopAll stops all robots
     */
    FrameContent(Team team, List<IconAction> buttons, Runnable stopAll, TeamPane teamPane, CommandPane commands) {
        super(new MigLayout("insets 0, gap 0, hidemode 3, wrap 1", "[grow, fill]"));
        this.buttons = buttons;
        this.teamPane = teamPane;
        StopPanel stop = new StopPanel(team, stopAll);
        team.addListener(new EventThreadTeamListener(stop));
        StopAlarm alarm = new StopAlarm(team);
        team.addListener(new EventThreadTeamListener(alarm));
        all = new JSplitPane(JSplitPane.VERTICAL_SPLIT, teamPane, commands);
        all.setResizeWeight(0.75);
        add(new FrameToolbar(buttons, stop), "wmin 0");
        add(alarm, "wmin 0, gap 8 8 0 6");
        add(all, "wmin 0, hmin 0, pushy, growy, gap 8 8 0 8");
    }

    /** Returns the split panes whose dividers are remembered, always in the same order. */
    List<JSplitPane> splits() {
        return List.of(teamPane, all);
    }

    /** Reads the pictures of the buttons from their files; may block. */
    void readPictures() {
        buttons.forEach(IconAction::readPicture);
    }
}
