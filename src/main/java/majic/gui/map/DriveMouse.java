package majic.gui.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.gui.kit.CommandChannel;
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
        submit(robot -> at(place.seenFrom(robot.origin())));
    }

    /** Sends the robots to a place with a name. */
    void drive(String place) {
        submit(robot -> place);
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
            Pose target = target(from, event.getPoint());
            submit(robot -> {
                Pose own = target.seenFrom(robot.origin());
                return at(own) + " " + Math.round(own.headingDeg());
            });
        }
    }

    private Pose target(Point from, Point to) {
        Point2D place = map.view().place(from.x, from.y);
        Point2D mouse = map.view().place(to.x, to.y);
        double heading = Math.toDegrees(Math.atan2(mouse.getY() - place.getY(), mouse.getX() - place.getX()));
        return new Pose(place.getX(), place.getY(), heading);
    }

    /** Returns the coordinates of a place as a command has them. */
    static String at(Pose place) {
        return Math.round(place.xMm()) + " " + Math.round(place.yMm());
    }

    /** Submits a command for each place: robots that were not placed have frames of their own. */
    private void submit(Function<MapScene.Robot, String> place) {
        Map<String, String> robots = map.chosen().stream()
                .collect(Collectors.groupingBy(
                        place,
                        LinkedHashMap::new,
                        Collectors.mapping(robot -> "" + robot.number(), Collectors.joining(","))));
        channel.submit(robots.entrySet().stream()
                .map(numbers -> numbers.getValue() + " goto " + numbers.getKey())
                .collect(Collectors.joining("\n")));
    }
}
