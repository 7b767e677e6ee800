package majic.gui;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;

/** Zooms the map with the wheel, moves it by dragging, shows all again after a double click. */
final class MapMouse extends MouseAdapter {
    private static final double ZOOM_PER_NOTCH = 1.15;

    private final TeamMap map;
    private Point last = new Point();

    MapMouse(TeamMap map) {
        this.map = map;
    }

    @Override
    public void mousePressed(MouseEvent event) {
        last = event.getPoint();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        map.choose(map.view().moved(event.getX() - last.x, event.getY() - last.y));
        last = event.getPoint();
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (event.getClickCount() == 2) {
            map.choose(null);
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM_PER_NOTCH, -event.getPreciseWheelRotation());
        map.choose(map.view().zoomed(factor, event.getPoint()));
    }
}
