package majic.panel.map;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;

/** What lies on the floor of a {@link ZoomableMap}. Asked on the event dispatch thread. */
public interface MapContent {
    /**
     * Paints it.
     *
     * @param pen in pixels; whatever is set on it is forgotten afterwards
     * @param view from the floor to the pixels
     */
    void paint(Graphics2D pen, MapView view);

    /**
     * What the map shows when it shows everything.
     *
     * @return mm on the floor, neither empty nor narrow
     */
    Rectangle2D extent();

    /**
     * What the map keeps free at its foot when it shows everything, for words that stand there.
     *
     * @return pixels
     */
    default int footPx() {
        return 0;
    }

    /** Forgets where robots have been and what they met there. */
    void clear();

    /**
     * What is said of a place that somebody points at.
     *
     * @param xMm on the floor
     * @param yMm on the floor
     * @param view how the floor lies on the map
     * @return a tip
     */
    default String tip(double xMm, double yMm, MapView view) {
        return String.format(
                Locale.ROOT,
                "x %.0f mm, y %.0f mm \u2013 wheel zooms, dragging moves, double click shows everything",
                xMm,
                yMm);
    }
}
