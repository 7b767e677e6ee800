package majic.gui.map;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.util.List;
import majic.bot.Pose;
import majic.gui.kit.Palette;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.OccupancyGrid;
import majic.nav.grid.OccupancyGrid.State;
import majic.panel.map.MapView;

/**
 * The map of the team as a picture of its cells: unknown ones are transparent, in the colours of the present look.
 * Takes some milliseconds to make for each million cells, so it is not made on the event dispatch thread. Immutable.
 */
public final class MapPicture {
    private static final byte FREE = 1;
    private static final byte OCCUPIED = 2;
    private static final int KINDS = 3;

    private final NavigationMap map;
    private final WritableRaster cells;
    private final Rectangle2D.Double known;

    /** Draws a map. */
    public MapPicture(NavigationMap map) {
        this.map = map;
        OccupancyGrid grid = map.grid();
        byte[] bytes = new byte[grid.width() * grid.height()];
        int left = grid.width();
        int right = 0;
        int low = grid.height();
        int high = 0;
        for (int row = 0; row < grid.height(); row++) {
            for (int column = 0; column < grid.width(); column++) {
                State state = grid.state(column, row);
                if (state != State.UNKNOWN) {
                    bytes[row * grid.width() + column] = state == State.FREE ? FREE : OCCUPIED;
                    left = Math.min(left, column);
                    right = Math.max(right, column + 1);
                    low = Math.min(low, row);
                    high = row + 1;
                }
            }
        }
        known = new Rectangle2D.Double(left, low, Math.max(0, right - left), Math.max(0, high - low));
        cells = Raster.createInterleavedRaster(
                new DataBufferByte(bytes, bytes.length),
                grid.width(),
                grid.height(),
                grid.width(),
                1,
                new int[] {0},
                null);
    }

    /** Returns the map that it shows. */
    public NavigationMap map() {
        return map;
    }

    /** From cells to the floor. */
    private AffineTransform onFloor() {
        Pose origin = map.grid().origin();
        AffineTransform transform = AffineTransform.getTranslateInstance(origin.xMm(), origin.yMm());
        transform.rotate(Math.toRadians(origin.headingDeg()));
        transform.scale(map.grid().cellMm(), map.grid().cellMm());
        return transform;
    }

    /** Returns the area on the floor of which something is known, mm; empty if there is none. */
    Rectangle2D extent() {
        return new Path2D.Double(known, onFloor()).getBounds2D();
    }

    /** Draws the cells. */
    void paint(Graphics2D g, MapView view) {
        Color[] colors = {
            new Color(0, true), Palette.mixed(Palette.text(), Palette.paper(), 0.15), Palette.mixed(0.75),
        };
        byte[][] parts = new byte[4][KINDS];
        for (int kind = 0; kind < KINDS; kind++) {
            parts[0][kind] = (byte) colors[kind].getRed();
            parts[1][kind] = (byte) colors[kind].getGreen();
            parts[2][kind] = (byte) colors[kind].getBlue();
            parts[3][kind] = (byte) colors[kind].getAlpha();
        }
        IndexColorModel model = new IndexColorModel(8, KINDS, parts[0], parts[1], parts[2], parts[3]);
        AffineTransform onScreen = view.transform();
        onScreen.concatenate(onFloor());
        g.drawImage(new BufferedImage(model, cells, false, null), onScreen, null);
    }

    /** Returns the places with names. */
    List<NavigationMap.Place> places() {
        return map.places();
    }

    /** Returns the lines that no robot crosses. */
    List<NavigationMap.ForbiddenLine> forbidden() {
        return map.forbidden();
    }

    /** Returns whether it shows this very map. */
    boolean shows(NavigationMap other) {
        return map == other;
    }
}
