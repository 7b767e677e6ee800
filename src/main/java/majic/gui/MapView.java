package majic.gui;

import java.awt.geom.Point2D;

/**
 * How the floor lies on the component: x right, y up, so pixels go down as y grows. Immutable.
 *
 * @param pixelsPerMm the scale, positive
 * @param left where x = 0 lies, pixels
 * @param top where y = 0 lies, pixels
 */
record MapView(double pixelsPerMm, double left, double top) {
    private static final double SMALLEST = 0.002;
    private static final double LARGEST = 4;

    /** The largest view that shows all of an extent. */
    static MapView fitting(Extent extent, int width, int height) {
        double scale = clamp(Math.min(width / extent.width(), height / extent.height()));
        double left = (width - scale * (extent.minX() + extent.maxX())) / 2;
        double top = (height + scale * (extent.minY() + extent.maxY())) / 2;
        return new MapView(scale, left, top);
    }

    double x(double xMm) {
        return left + pixelsPerMm * xMm;
    }

    double y(double yMm) {
        return top - pixelsPerMm * yMm;
    }

    /** The place on the floor under a pixel. */
    MapScene.Point place(Point2D pixel) {
        return new MapScene.Point((pixel.getX() - left) / pixelsPerMm, (top - pixel.getY()) / pixelsPerMm);
    }

    /** The view with everything larger by a factor, and the same place under a pixel. */
    MapView zoomed(double factor, Point2D fixed) {
        double scale = clamp(pixelsPerMm * factor);
        double real = scale / pixelsPerMm;
        return new MapView(
                scale, fixed.getX() - real * (fixed.getX() - left), fixed.getY() - real * (fixed.getY() - top));
    }

    MapView moved(double rightPixels, double downPixels) {
        return new MapView(pixelsPerMm, left + rightPixels, top + downPixels);
    }

    private static double clamp(double scale) {
        return Math.max(SMALLEST, Math.min(LARGEST, scale));
    }
}
