package majic.gui.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.gui.kit.CommandChannel;
import majic.nav.Destination;
import majic.nav.grid.NavigationMap.Place;
import org.jspecify.annotations.Nullable;

/**
 * Sends the selected robots to a place on the map by the command {@code goto}: with Ctrl, to where the mouse is
 * pressed, looking to where it is dragged. Must be used on the event dispatch thread.
 */
final class DriveMouse extends MouseAdapter {
    private static final int DRAG_PX = 4;

    private final TeamMap map;
    private final CommandChannel channel;
    private @Nullable Point pressed;

    /** Creates the mouse listener; it must also be added for mouse motions. */
    DriveMouse(TeamMap map, CommandChannel channel) {
        this.map = map;
        this.channel = channel;
    }

    /** Returns whether there is a robot to send. */
    boolean hasRobots() {
        return !map.chosen().isEmpty();
    }

    /** Sends the robots to a place on the floor, whatever the heading. */
    void drive(Pose place) {
        submit(new Waypoint(new Destination(place, false), ""));
    }

    /** Sends the robots to a place with a name. */
    void drive(Place place) {
        submit(new Waypoint(new Destination(place), place.name()));
    }

    @Override
    public void mousePressed(MouseEvent event) {
        boolean begins = SwingUtilities.isLeftMouseButton(event)
                && !event.isPopupTrigger()
                && !event.isShiftDown()
                && (event.isControlDown() || event.isMetaDown());
        pressed = begins && hasRobots() && map.topRobotAt(event.getPoint()).isEmpty() ? event.getPoint() : null;
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (pressed != null) {
            map.previewTarget(target(pressed, event.getPoint()));
        }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        Point from = pressed;
        pressed = null;
        if (from == null) {
            return;
        }
        map.previewTarget(null);
        if (map.contains(event.getPoint()) && event.getPoint().distance(from) > DRAG_PX) {
            submit(new Waypoint(new Destination(target(from, event.getPoint()), true), ""));
        }
    }

    private Pose target(Point from, Point to) {
        return map.view().headed(map.view().pose(from), to);
    }

    private void submit(Waypoint target) {
        channel.submit(target.commands(map.chosen()));
    }
}
