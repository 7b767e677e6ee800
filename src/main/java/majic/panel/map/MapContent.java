package majic.panel.map;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.text.Texts;

/** The content of a {@link ZoomableMap}. Called on the event dispatch thread. */
public interface MapContent {
    /**
     * Paints the content.
     *
     * @param pen in pixels; its settings are discarded afterwards
     * @param view from the floor to the pixels
     */
    void paint(Graphics2D pen, MapView view);

    /**
     * Returns the area that the map shows when it shows everything.
     *
     * @return mm on the floor, neither empty nor narrow
     */
    Rectangle2D extent();

    /**
     * Returns the height that the map keeps free at its bottom when it shows everything, for text.
     *
     * @param widthPx the width of the map
     * @return pixels
     */
    default int footPx(int widthPx) {
        return 0;
    }

    /** Clears the robots' trails and detected points. */
    void clear();

    /**
     * Returns the tool tip for a place under the mouse pointer.
     *
     * @param xMm on the floor
     * @param yMm on the floor
     * @param view the mapping from floor to pixels
     * @return a tip
     */
    default String tip(double xMm, double yMm, MapView view) {
        return Texts.of(MapContent.class).get("placeTip", Math.round(xMm), Math.round(yMm));
    }
}
