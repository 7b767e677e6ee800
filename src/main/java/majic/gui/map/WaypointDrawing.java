package majic.gui.map;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import majic.bot.Pose;
import majic.nav.Destination;
import majic.panel.map.ZoomableMap;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Draws waypoints on the map, which become a script. A click adds one, a drag one with a heading; the keys that the map
 * shows do the same, take the last one back, and end it. Must be used on the event dispatch thread.
 */
final class WaypointDrawing implements KeyListener {
    private static final Texts TEXTS = Texts.of(WaypointDrawing.class);
    private static final int DRAG_PX = 4;

    private final ZoomableMap map;
    private final TeamFloor floor;
    private final Consumer<String> openScript;
    private final Consumer<String> showError;
    private final List<Waypoint> waypoints = new ArrayList<>();
    private boolean active;
    private @Nullable Point pressed;

    /**
     * Creates it, inactive.
     *
     * @param map shows the floor
     * @param openScript receives the script of the waypoints
     * @param showError receives why there is no script yet
     */
    WaypointDrawing(ZoomableMap map, TeamFloor floor, Consumer<String> openScript, Consumer<String> showError) {
        this.map = map;
        this.floor = floor;
        this.openScript = openScript;
        this.showError = showError;
    }

    /** Begins with the first waypoint; has no effect while it is active. */
    void begin() {
        if (!active) {
            active = true;
            map.addKeyListener(this);
            show();
        }
    }

    private void end() {
        active = false;
        pressed = null;
        waypoints.clear();
        map.removeKeyListener(this);
        floor.previewTarget(null);
        show(null);
    }

    boolean isActive() {
        return active;
    }

    private void show() {
        show(List.copyOf(waypoints));
    }

    /** Shows waypoints, also to screen readers; null ends that. */
    private void show(@Nullable List<Waypoint> drawn) {
        floor.previewWaypoints(drawn);
        map.getAccessibleContext().setAccessibleDescription(floor.description());
        map.repaint();
    }

    /** Handles an event of a mouse button, and the motion of a drag. */
    void mouse(MouseEvent event) {
        switch (event.getID()) {
            case MouseEvent.MOUSE_PRESSED -> press(event);
            case MouseEvent.MOUSE_DRAGGED -> drag(event);
            case MouseEvent.MOUSE_RELEASED -> release(event);
            case MouseEvent.MOUSE_CLICKED -> click(event);
            default -> {}
        }
    }

    private void press(MouseEvent event) {
        map.requestFocusInWindow();
        boolean begins = SwingUtilities.isLeftMouseButton(event) && !event.isPopupTrigger();
        pressed = begins ? event.getPoint() : null;
    }

    private void drag(MouseEvent event) {
        if (pressed != null) {
            floor.previewTarget(isDragged(pressed, event) ? heading(pressed, event) : null);
            map.repaint();
        }
    }

    private void release(MouseEvent event) {
        Point from = pressed;
        pressed = null;
        floor.previewTarget(null);
        map.repaint();
        if (from == null || !map.contains(event.getPoint())) {
            return;
        }
        if (isDragged(from, event)) {
            add(new Waypoint(new Destination(heading(from, event), true), ""));
        } else if (!isDoubleClick(event)) {
            add(at(from));
        }
    }

    /** Ends it only with the last event of the second click, which would otherwise be a double click on the map. */
    private void click(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event) && isDoubleClick(event)) {
            finish();
        }
    }

    /** A slow click during which the mouse moves by a pixel has the count 0. */
    private static boolean isDoubleClick(MouseEvent event) {
        return event.getClickCount() > 0 && event.getClickCount() % 2 == 0;
    }

    private static boolean isDragged(Point from, MouseEvent event) {
        return event.getPoint().distance(from) > DRAG_PX;
    }

    private Pose heading(Point from, MouseEvent event) {
        return map.view().headed(at(from).at().pose(), event.getPoint());
    }

    private Waypoint at(Point pixel) {
        return floor.placeAt(pixel, map.view())
                .map(place -> new Waypoint(new Destination(place), place.name()))
                .orElseGet(() -> new Waypoint(new Destination(map.view().pose(pixel), false), ""));
    }

    private void add(Waypoint waypoint) {
        waypoints.add(waypoint);
        show();
    }

    @Override
    public void keyPressed(KeyEvent event) {
        if (event.getModifiersEx() != 0) {
            return;
        }
        switch (event.getKeyCode()) {
            case KeyEvent.VK_SPACE -> add(at(middle()));
            case KeyEvent.VK_BACK_SPACE -> removeLast();
            case KeyEvent.VK_ENTER -> finish();
            case KeyEvent.VK_ESCAPE -> end();
            default -> {
                return;
            }
        }
        event.consume();
    }

    private Point middle() {
        return new Point(map.getWidth() / 2, map.getHeight() / 2);
    }

    private void removeLast() {
        if (!waypoints.isEmpty()) {
            waypoints.remove(waypoints.size() - 1);
            show();
        }
    }

    /** Opens the script, or shows what is missing for it. */
    private void finish() {
        List<MapScene.Robot> robots = floor.chosen();
        if (robots.isEmpty()) {
            showError.accept(TEXTS.get("waypoints.noRobot"));
        } else if (waypoints.isEmpty()) {
            showError.accept(TEXTS.get("waypoints.none"));
        } else {
            String script = Waypoint.script(waypoints, robots);
            end();
            openScript.accept(script);
        }
    }

    @Override
    public void keyTyped(KeyEvent event) {}

    @Override
    public void keyReleased(KeyEvent event) {}
}
