package majic.gui.map;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** The part of a map that has labels already. A further label that would cover one of them is left out. */
final class LabelRoom {
    /** By how much labels may overlap in pixels. */
    private static final double OVERLAP_PX = 2;

    private final List<Rectangle2D> taken = new ArrayList<>();

    /**
     * Takes the room for a label, if it is free.
     *
     * @param label its bounds in pixels
     * @return whether it was free
     */
    boolean take(Rectangle2D label) {
        Rectangle2D inner = new Rectangle2D.Double(
                label.getX() + OVERLAP_PX / 2,
                label.getY() + OVERLAP_PX / 2,
                Math.max(1, label.getWidth() - OVERLAP_PX),
                Math.max(1, label.getHeight() - OVERLAP_PX));
        if (taken.stream().anyMatch(inner::intersects)) {
            return false;
        }
        return taken.add(inner);
    }
}
