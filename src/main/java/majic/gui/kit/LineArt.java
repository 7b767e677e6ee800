package majic.gui.kit;

import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Path2D;

/** Collects the lines of a drawing. Places are given as x, y, to the right and down. */
public final class LineArt {
    private final Path2D path = new Path2D.Double();

    /** Adds a line through these places. */
    public LineArt line(double... places) {
        path.moveTo(places[0], places[1]);
        for (int index = 2; index < places.length; index += 2) {
            path.lineTo(places[index], places[index + 1]);
        }
        return this;
    }

    /** Adds a line through these places and back to the first. */
    public LineArt area(double... places) {
        line(places);
        path.closePath();
        return this;
    }

    /** Adds a circle around a place. */
    public LineArt circle(double x, double y, double radius) {
        return arc(x, y, radius, 0, 360);
    }

    /**
     * Adds a part of a circle around a place.
     *
     * @param startDeg where it begins: 0 is to the right, 90 above
     * @param extentDeg its length, counterclockwise positive
     */
    public LineArt arc(double x, double y, double radius, double startDeg, double extentDeg) {
        int type = extentDeg == 360 ? Arc2D.CHORD : Arc2D.OPEN;
        path.append(new Arc2D.Double(x - radius, y - radius, 2 * radius, 2 * radius, startDeg, extentDeg, type), false);
        return this;
    }

    /** Adds a cubic curve: its first place, two control places, its last place. */
    public LineArt curve(double... places) {
        path.moveTo(places[0], places[1]);
        path.curveTo(places[2], places[3], places[4], places[5], places[6], places[7]);
        return this;
    }

    /** Returns what was added so far. */
    public Shape shape() {
        return path;
    }
}
