package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.CardLayout;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import majic.gui.bots.TeamTabs;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.RobotSelection;
import majic.gui.map.MapFeed;
import majic.gui.map.TeamMap;
import majic.script.Session;
import majic.team.Team;

/**
 * Shows the map and the tabbed panes of the robots beside each other, and in place of the latter another component
 * while there is no robot. While two panes are compared, the second one is between the map and the tabs, which stay
 * where they are; it takes its width from the map, or its whole place if that is narrow. Where there is no room for a
 * map that can be read, the tabs are alone.
 */
final class TeamPane extends JSplitPane {
    private static final long serialVersionUID = 1L;

    /** Least width in pixels of a second pane beside the map. */
    private static final int LEAST_COMPARED = 340;

    /** Width in pixels of the narrowest map. */
    private static final int LEAST_MAP = 160;

    private static final String EMPTY = "empty";
    private static final String ROBOTS = "robots";
    private static final int NOT_COMPARED = -1;

    private final transient Team team;
    private final TeamMap map = new TeamMap();
    private final TeamTabs mainPane;
    private final transient MapFeed mapFeed;
    private final CardLayout cards = new CardLayout();
    private final JPanel robots = new JPanel(cards);
    private int divider;

    /** Where the divider was when the comparison began, and where the tabs begin since. */
    private int before = NOT_COMPARED;

    private boolean coversMap;

    /**
     * Places the parts; {@link #start()} lets them follow the team.
     *
     * @param whenEmpty shown in place of the tabs while there is no robot
     */
    TeamPane(Session session, RobotSelection selection, TeamTabs mainPane, JComponent whenEmpty) {
        super(HORIZONTAL_SPLIT);
        this.mainPane = mainPane;
        team = session.team();
        mapFeed = new MapFeed(team, session.factory(), session.map(), map::show);
        map.select(team, selection, mainPane::showMenu);
        robots.add(whenEmpty, EMPTY);
        robots.add(mainPane, ROBOTS);
        setLeftComponent(map);
        setRightComponent(robots);
        setResizeWeight(0.58);
        mainPane.addPropertyChangeListener(TeamTabs.COMPARING, change -> fit());
        mainPane.addContainerListener(new ContainerAdapter() {
            @Override
            public void componentAdded(ContainerEvent event) {
                showRobots();
            }

            @Override
            public void componentRemoved(ContainerEvent event) {
                showRobots();
            }
        });
        showRobots();
    }

    private void showRobots() {
        cards.show(robots, mainPane.getTabCount() == 0 ? EMPTY : ROBOTS);
    }

    @Override
    public void doLayout() {
        divider = Math.max(divider, getDividerSize());
        int room = getWidth() - divider - robots.getMinimumSize().width;
        boolean hasRoom = room >= UIScale.scale(LEAST_MAP);
        map.setVisible(hasRoom && !coversMap);
        setDividerSize(map.isVisible() ? divider : 0);
        mainPane.placeTabs(before == NOT_COMPARED || !hasRoom ? 0 : coversMap ? before + divider : taken());
        int was = getDividerLocation();
        super.doLayout();
        if (before != NOT_COMPARED && map.isVisible()) {
            before += getDividerLocation() - was;
        }
    }

    /** Returns the width that the second pane has taken from the map. */
    private int taken() {
        return Math.max(0, before - getDividerLocation());
    }

    void start() {
        team.addListener(new EventThreadTeamListener(mainPane));
        mapFeed.start();
    }

    /** Closes the robots' own windows, and ends the updates of the map. */
    void close() {
        mapFeed.close();
        mainPane.close();
    }

    TeamMap map() {
        return map;
    }

    /** Returns where the divider is while no panes are compared. */
    int usualDividerLocation() {
        return before == NOT_COMPARED ? getDividerLocation() : before;
    }

    private void fit() {
        if (mainPane.isComparing() && before == NOT_COMPARED) {
            before = getDividerLocation();
            int most = before - UIScale.scale(LEAST_MAP);
            coversMap = map.isVisible() && most < UIScale.scale(LEAST_COMPARED);
            if (map.isVisible() && !coversMap) {
                setDividerLocation(before - Math.min(most, mainPane.widthOfPanes()));
            }
        } else if (!mainPane.isComparing() && before != NOT_COMPARED) {
            coversMap = false;
            setDividerLocation(before);
            before = NOT_COMPARED;
        }
        revalidate();
    }
}
