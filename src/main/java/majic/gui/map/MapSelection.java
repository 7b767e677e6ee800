package majic.gui.map;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.SwingUtilities;
import majic.gui.kit.RobotSelection;
import majic.team.Member;
import majic.team.Team;

/**
 * Selects the robot that is clicked on the map; with Ctrl, adds it to the selection or removes it. Where robots
 * overlap, each further click selects the next one. A right click opens the menu of the robot.
 */
public final class MapSelection extends MouseAdapter {
    /** Opens the context menu of a robot. */
    @FunctionalInterface
    public interface Menu {
        /**
         * Opens the menu.
         *
         * @param on the component that was clicked, and the place in it
         */
        void show(Member member, Component on, int x, int y);
    }

    /** How far the mouse may move between press and release of a click, in pixels. */
    private static final int CLICK_PX = 4;

    private final TeamMap map;
    private final Team team;
    private final RobotSelection selection;
    private final Menu menu;
    private Point pressed = new Point();

    MapSelection(TeamMap map, Team team, RobotSelection selection, Menu menu) {
        this.map = map;
        this.team = team;
        this.selection = selection;
        this.menu = menu;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        pressed = event.getPoint();
        openMenu(event);
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        openMenu(event);
        boolean isClick = event.getPoint().distance(pressed) <= CLICK_PX && !event.isShiftDown();
        List<Member> members = robotsUnder(event);
        if (isClick && SwingUtilities.isLeftMouseButton(event) && !members.isEmpty()) {
            choose(next(members), event.isControlDown() || event.isMetaDown());
        }
    }

    private void openMenu(MouseEvent event) {
        List<Member> members = robotsUnder(event);
        if (event.isPopupTrigger() && !members.isEmpty()) {
            menu.show(members.get(0), map, event.getX(), event.getY());
        }
    }

    private List<Member> robotsUnder(MouseEvent event) {
        List<Integer> hit = map.robotsAt(event.getPoint());
        return team.members().stream()
                .filter(member -> hit.contains(member.number()))
                .toList();
    }

    private void choose(Member member, boolean isFurther) {
        if (isFurther) {
            selection.toggle(member);
        } else {
            selection.select(member);
        }
    }

    /** Returns the robot behind the last selected one of those under the mouse. */
    private Member next(List<Member> members) {
        int last = -1;
        for (int index = 0; index < members.size(); index++) {
            if (selection.contains(members.get(index))) {
                last = index;
            }
        }
        return members.get((last + 1) % members.size());
    }
}
