package majic.panel.map;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import majic.panel.DrawingColors;
import majic.panel.KeyAction;
import majic.panel.ScaledIcon;
import majic.text.Texts;

/**
 * The actions on a map: each has a key that works while the map has the focus; most have a button too, whose icon they
 * are.
 */
enum MapAction implements ScaledIcon {
    /** Zooms in. */
    ZOOM_IN("zoomIn", List.of("+")),
    /** Zooms out. */
    ZOOM_OUT("zoomOut", List.of("-")),
    /** Shows everything. */
    FIT("fit", List.of("0")),
    /** Keeps the robot in the middle. */
    FOLLOW("follow", List.of("f")),
    /** Keeps the robot in the middle, with its heading up. */
    AHEAD_UP("aheadUp", List.of("u")),
    /** Clears trails and echoes; by button alone, because cleared data cannot be restored. */
    CLEAR("clear", List.of()),
    /** Moves the view to the left. */
    LEFT("left", List.of("LEFT")),
    /** Moves the view to the right. */
    RIGHT("right", List.of("RIGHT")),
    /** Moves the view up. */
    UP("up", List.of("UP")),
    /** Moves the view down. */
    DOWN("down", List.of("DOWN"));

    /** The actions with a button, in the order of the buttons; the last one is set apart. */
    static final List<MapAction> WITH_BUTTON = List.of(ZOOM_IN, ZOOM_OUT, FIT, FOLLOW, AHEAD_UP, CLEAR);

    private static final int STEP_PX = 40;
    private static final int ICON_PX = 14;
    private static final Texts TEXTS = Texts.of(MapAction.class);

    private final String text;
    private final List<String> keys;

    MapAction(String text, List<String> keys) {
        this.text = text;
        this.keys = keys;
    }

    String title() {
        return TEXTS.get(text);
    }

    /** Returns the tool tip, with the key of the same action. */
    String tip() {
        return keys.isEmpty() ? title() : TEXTS.get("keyTip", title(), keys.get(0));
    }

    boolean toggles() {
        return this == FOLLOW || this == AHEAD_UP;
    }

    /** Returns whether the action applies to this map: actions about the robot need one to follow. */
    boolean suits(ZoomableMap map) {
        return map.hasRobot() || !toggles();
    }

    boolean isOn(ZoomableMap map) {
        return this == FOLLOW && map.follows() || this == AHEAD_UP && map.hasAheadUp();
    }

    void perform(ZoomableMap map) {
        switch (this) {
            case ZOOM_IN -> map.zoom(1.25);
            case ZOOM_OUT -> map.zoom(0.8);
            case FIT -> map.fit();
            case FOLLOW -> map.toggleFollow();
            case AHEAD_UP -> map.toggleAheadUp();
            case CLEAR -> map.clear();
            case LEFT -> map.drag(STEP_PX, 0);
            case RIGHT -> map.drag(-STEP_PX, 0);
            case UP -> map.drag(0, STEP_PX);
            case DOWN -> map.drag(0, -STEP_PX);
        }
    }

    static void bindKeys(ZoomableMap map) {
        for (MapAction action : values()) {
            if (!action.suits(map)) {
                continue;
            }
            for (String key : action.keys) {
                KeyAction.bind(map, JComponent.WHEN_FOCUSED, keyStroke(key), event -> action.perform(map));
            }
        }
    }

    /** Returns the typed character, or a key by its name. */
    private static KeyStroke keyStroke(String key) {
        return key.length() == 1 ? KeyStroke.getKeyStroke(key.charAt(0)) : KeyStroke.getKeyStroke(key);
    }

    /** Draws the symbol of the button, in the colour of text. */
    @Override
    public void paint(Component on, Graphics2D pen) {
        pen.setColor(DrawingColors.current().grey(0.85));
        pen.setStroke(DrawingColors.stroke(1.5));
        switch (this) {
            case ZOOM_IN -> plus(pen);
            case ZOOM_OUT -> line(pen, 2, 7, 12, 7);
            case FIT -> corners(pen);
            case FOLLOW -> target(pen);
            case AHEAD_UP -> pointer(pen);
            case CLEAR -> bin(pen);
            case LEFT, RIGHT, UP, DOWN -> {}
        }
    }

    private static void line(Graphics2D pen, double x1, double y1, double x2, double y2) {
        pen.draw(new Line2D.Double(x1, y1, x2, y2));
    }

    private static void plus(Graphics2D pen) {
        line(pen, 2, 7, 12, 7);
        line(pen, 7, 2, 7, 12);
    }

    private static void corners(Graphics2D pen) {
        for (int quarter = 0; quarter < 4; quarter++) {
            line(pen, 1.5, 1.5, 5, 1.5);
            line(pen, 1.5, 1.5, 1.5, 5);
            pen.rotate(Math.PI / 2, ICON_PX / 2.0, ICON_PX / 2.0);
        }
    }

    private static void target(Graphics2D pen) {
        pen.draw(new Ellipse2D.Double(3, 3, 8, 8));
        pen.fill(new Ellipse2D.Double(5.5, 5.5, 3, 3));
        for (int quarter = 0; quarter < 4; quarter++) {
            line(pen, 7, 0.5, 7, 3);
            pen.rotate(Math.PI / 2, ICON_PX / 2.0, ICON_PX / 2.0);
        }
    }

    private static void pointer(Graphics2D pen) {
        Path2D pointer = new Path2D.Double();
        pointer.moveTo(7, 1);
        pointer.lineTo(12, 12.5);
        pointer.lineTo(7, 9.5);
        pointer.lineTo(2, 12.5);
        pointer.closePath();
        pen.draw(pointer);
    }

    private static void bin(Graphics2D pen) {
        line(pen, 1.5, 3.5, 12.5, 3.5);
        line(pen, 5, 1.5, 9, 1.5);
        pen.draw(new Rectangle2D.Double(3, 3.5, 8, 9));
        line(pen, 5.7, 6, 5.7, 10);
        line(pen, 8.3, 6, 8.3, 10);
    }

    @Override
    public int width() {
        return ICON_PX;
    }
}
