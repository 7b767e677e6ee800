package majic.gui.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Set;
import javax.swing.SwingUtilities;
import majic.gui.kit.RobotSelection;
import majic.team.Member;
import majic.team.Team;

/**
 * Selects the robot that is clicked on the map; with Ctrl, adds it to the selection or removes it. Where robots overlap,
 * each further click selects the next one.
 */
final class MapSelection extends MouseAdapter {
    /** How far the mouse may move between press and release of a click, in pixels. */
    private static final int CLICK_PX = 4;

    private final TeamMap map;
    private final Team team;
    private final RobotSelection selection;
    private Point pressed = new Point();

    MapSelection(TeamMap map, Team team, RobotSelection selection) {
        this.map = map;
        this.team = team;
        this.selection = selection;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        pressed = event.getPoint();
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event) && event.getPoint().distance(pressed) <= CLICK_PX) {
            clicked(event);
        }
    }

    private void clicked(MouseEvent event) {
        Set<Integer> hit = Set.copyOf(map.robotsAt(event.getPoint()));
        List<Member> members = team.members().stream()
                .filter(member -> hit.contains(member.number()))
                .toList();
        if (members.isEmpty()) {
            return;
        }
        Member next = next(members);
        if (event.isControlDown() || event.isMetaDown()) {
            selection.toggle(next);
        } else {
            selection.select(next);
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
