package majic.panel.map;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;

/** Zooms a map with the wheel, moves it by dragging without Shift and Ctrl, shows everything after a double click. */
final class MapMouse extends MouseAdapter {
    private static final double ZOOM_PER_NOTCH = 1.15;

    private final ZoomableMap map;
    private Point last = new Point();

    MapMouse(ZoomableMap map) {
        this.map = map;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        last = event.getPoint();
        map.requestFocusInWindow();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        boolean plain = !event.isShiftDown() && !event.isControlDown() && !event.isMetaDown();
        if (SwingUtilities.isLeftMouseButton(event) && plain) {
            map.drag(event.getX() - last.x, event.getY() - last.y);
            last = event.getPoint();
        }
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (SwingUtilities.isLeftMouseButton(event) && event.getClickCount() == 2) {
            map.fit();
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        map.zoom(Math.pow(ZOOM_PER_NOTCH, -event.getPreciseWheelRotation()), event.getX(), event.getY());
    }
}
