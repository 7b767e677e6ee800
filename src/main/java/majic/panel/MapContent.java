package majic.panel;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;

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
     * What the map keeps in its middle when it follows.
     *
     * @return on the floor
     */
    Pose pose();

    /**
     * What the map shows when it shows everything.
     *
     * @return mm on the floor, neither empty nor narrow
     */
    Rectangle2D extent();

    /**
     * The scale at which the robot and what is around it are seen well.
     *
     * @param sidePx the shorter side of the map
     * @return pixels a mm
     */
    double nearPxPerMm(int sidePx);

    /** Forgets where the robot has been and what it met there. */
    void clear();
}
