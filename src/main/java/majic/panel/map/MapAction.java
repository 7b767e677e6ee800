package majic.panel.map;

import java.util.List;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import majic.panel.KeyAction;
import majic.text.Texts;

/** The actions on a map: each has a key that works while the map has the focus; most have a button too. */
enum MapAction {
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
}
