package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import majic.gui.bots.RobotActions;
import majic.gui.bots.RobotPanels;
import majic.gui.bots.StripScroll;
import majic.gui.bots.TeamStrip;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.RobotSelection;
import majic.gui.map.MapFeed;
import majic.gui.map.TeamMap;
import majic.script.Session;
import majic.team.Member;
import majic.team.Team;

/**
 * Shows the team: the cards, the map and the panels beside each other. While two panels are compared, the map is
 * narrower; afterwards it has its width again, unless the user has moved the divider meanwhile.
 */
final class TeamPane extends JSplitPane {
    private static final long serialVersionUID = 1L;
    private static final Dimension PANELS = new Dimension(470, 400);
    private static final Dimension LEAST_PANELS = new Dimension(360, 200);

    /** Width in pixels for each of two panels. */
    private static final int COMPARED_WIDTH = 390;

    private static final int NOT_COMPARED = -1;

    private final transient Team team;
    private final TeamMap map = new TeamMap();
    private final TeamStrip strip;
    private final RobotPanels panels;
    private final transient MapFeed mapFeed;
    private int before = NOT_COMPARED;
    private int during;

    /**
     * Creates the parts; {@link #start()} lets them follow the team.
     *
     * @param whenEmpty shown in place of the panels while there is no robot
     */
    TeamPane(Session session, RobotSelection selection, RobotActions actions, JComponent whenEmpty) {
        super(HORIZONTAL_SPLIT);
        team = session.team();
        panels = new RobotPanels(team, selection, actions, whenEmpty);
        strip = new TeamStrip(team, selection, actions, panels::openWindow);
        mapFeed = new MapFeed(team, session.factory(), map::show);
        map.select(team, selection, strip::showMenu);
        setLeftComponent(new TeamOverview(new StripScroll(strip), map));
        setRightComponent(panels);
        setResizeWeight(0.58);
        panels.setPreferredSize(UIScale.scale(PANELS));
        panels.setMinimumSize(UIScale.scale(LEAST_PANELS));
        panels.addPropertyChangeListener(RobotPanels.COMPARING, change -> fit());
    }

    void start() {
        team.addListener(new EventThreadTeamListener(panels));
        team.addListener(new EventThreadTeamListener(strip));
        mapFeed.start();
    }

    /** Closes the robots' own windows, and ends the updates of the map. */
    void close() {
        mapFeed.close();
        panels.close();
    }

    TeamMap map() {
        return map;
    }

    void focusPad() {
        panels.focusPad();
    }

    /** Shows a change of a robot of which the team sends no event. */
    void changed(Member member) {
        panels.ownerChanged(member);
        strip.ownerChanged(member);
    }

    /** Returns where the divider is while no panels are compared. */
    int usualDividerLocation() {
        return before == NOT_COMPARED || getDividerLocation() != during ? getDividerLocation() : before;
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
