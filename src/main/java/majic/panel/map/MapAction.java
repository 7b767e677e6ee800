package majic.panel.map;

import java.awt.event.ActionEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;
import majic.text.Texts;

/** The actions on a map: each has a key that works while the map has the focus; most have a button too. */
enum MapAction {
    /** Zooms in. */
    ZOOM_IN("zoomIn", List.of("+"), map -> map.zoom(1.25)),
    /** Zooms out. */
    ZOOM_OUT("zoomOut", List.of("-"), map -> map.zoom(0.8)),
    /** Shows everything. */
    FIT("fit", List.of("0"), ZoomableMap::fit),
    /** Keeps the robot in the middle. */
    FOLLOW("follow", List.of("f"), ZoomableMap::toggleFollow, ZoomableMap::follows),
    /** Keeps the robot in the middle, with its heading up. */
    AHEAD_UP("aheadUp", List.of("u"), ZoomableMap::toggleAheadUp, ZoomableMap::hasAheadUp),
    /** Clears trails and echoes; by button alone, because cleared data cannot be restored. */
    CLEAR("clear", List.of(), ZoomableMap::clear),
    /** Moves the view to the left. */
    LEFT("left", List.of("LEFT"), map -> map.drag(MapAction.STEP_PX, 0)),
    /** Moves the view to the right. */
    RIGHT("right", List.of("RIGHT"), map -> map.drag(-MapAction.STEP_PX, 0)),
    /** Moves the view up. */
    UP("up", List.of("UP"), map -> map.drag(0, MapAction.STEP_PX)),
    /** Moves the view down. */
    DOWN("down", List.of("DOWN"), map -> map.drag(0, -MapAction.STEP_PX));

    /** The actions with a button, in the order of the buttons; the last one is set apart. */
    static final List<MapAction> WITH_BUTTON = List.of(ZOOM_IN, ZOOM_OUT, FIT, FOLLOW, AHEAD_UP, CLEAR);

    private static final int STEP_PX = 40;
    private static final Texts TEXTS = Texts.of(MapAction.class);

    private final String text;
    private final List<String> keys;
    private final Consumer<ZoomableMap> effect;
    private final Predicate<ZoomableMap> state;
    private final boolean toggles;

    MapAction(String text, List<String> keys, Consumer<ZoomableMap> effect) {
        this(text, keys, effect, map -> false, false);
    }

    MapAction(String text, List<String> keys, Consumer<ZoomableMap> effect, Predicate<ZoomableMap> state) {
        this(text, keys, effect, state, true);
    }

    MapAction(
            String text,
            List<String> keys,
            Consumer<ZoomableMap> effect,
            Predicate<ZoomableMap> state,
            boolean toggles) {
        this.text = text;
        this.keys = keys;
        this.effect = effect;
        this.state = state;
        this.toggles = toggles;
    }

    String title() {
        return TEXTS.get(text);
    }

    /** Returns the tool tip, with the key of the same action. */
    String tip() {
        return keys.isEmpty() ? title() : TEXTS.get("keyTip", title(), keys.get(0));
    }

    boolean toggles() {
        return toggles;
    }

    /** Returns whether the action applies to this map: actions about the robot need one to follow. */
    boolean suits(ZoomableMap map) {
        return map.hasRobot() || this != FOLLOW && this != AHEAD_UP;
    }

    boolean isOn(ZoomableMap map) {
        return state.test(map);
    }

    void perform(ZoomableMap map) {
        effect.accept(map);
    }

    static void bindKeys(ZoomableMap map) {
        for (MapAction action : values()) {
            if (!action.suits(map)) {
                continue;
            }
            action.keys.forEach(key -> map.getInputMap().put(keyStroke(key), action));
            map.getActionMap().put(action, new Performing(map, action));
        }
    }

    /** Returns the typed character, or a key by its name. */
    private static KeyStroke keyStroke(String key) {
        return key.length() == 1 ? KeyStroke.getKeyStroke(key.charAt(0)) : KeyStroke.getKeyStroke(key);
    }

    private static final class Performing extends AbstractAction {
        private static final long serialVersionUID = 1;
        private final transient ZoomableMap map;
        private final MapAction action;

        Performing(ZoomableMap map, MapAction action) {
            this.map = map;
            this.action = action;
        }

        @Override
        public void actionPerformed(ActionEvent event) {
            action.perform(map);
        }
    }
}
