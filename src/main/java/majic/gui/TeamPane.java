package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import majic.gui.bots.RobotPanels;
import majic.gui.bots.TeamStrip;
import majic.gui.map.TeamMap;
import net.miginfocom.swing.MigLayout;

/**
 * Places the cards, the team map and the panels beside each other. While two panels are compared, the map is narrower;
 * afterwards it has its width again, unless the user has moved the divider meanwhile.
 */
final class TeamPane extends JSplitPane {
    private static final long serialVersionUID = 1L;
    private static final Dimension PANELS = new Dimension(470, 400);
    private static final Dimension LEAST_PANELS = new Dimension(360, 200);

    /** Width in pixels for each of two panels. */
    private static final int COMPARED_WIDTH = 390;

    private static final int NOT_COMPARED = -1;

    private final RobotPanels panels;
    private int before = NOT_COMPARED;
    private int during;

    TeamPane(TeamStrip strip, TeamMap map, RobotPanels panels) {
        super(HORIZONTAL_SPLIT);
        this.panels = panels;
        JPanel team = new JPanel(
                new MigLayout("insets 0, gap 0, hidemode 3", "[fill][grow, fill, shrinkprio 200]", "[grow, fill]"));
        team.add(strip, "cell 0 0, hmin 0, gapright 6");
        team.add(map, "cell 1 0, hmin 0");
        setLeftComponent(team);
        setRightComponent(panels);
        setResizeWeight(0.58);
        panels.setPreferredSize(UIScale.scale(PANELS));
        panels.setMinimumSize(UIScale.scale(LEAST_PANELS));
        panels.addPropertyChangeListener(RobotPanels.COMPARING, change -> fit());
    }

    private void fit() {
        if (panels.isComparing() && before == NOT_COMPARED) {
            before = getDividerLocation();
            int wanted = getWidth() - getDividerSize() - 2 * UIScale.scale(COMPARED_WIDTH);
            setDividerLocation(Math.min(before, Math.max(wanted, getMinimumDividerLocation())));
            during = getDividerLocation();
        } else if (!panels.isComparing() && before != NOT_COMPARED) {
            if (getDividerLocation() == during) {
                setDividerLocation(before);
            }
            before = NOT_COMPARED;
        }
    }
}
