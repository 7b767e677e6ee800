package majic.panel.map;

import java.awt.Point;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;

/**
 * The mapping of a floor to a component: the place in the middle, the scale, the direction that points up. On the floor
 * x and y are mm, angles counterclockwise positive; pixels go right and down. Immutable.
 *
 * @param pxPerMm the scale, {@value #SMALLEST} to {@value #LARGEST}; a value outside is brought inside
 * @param xMm what is in the middle
 * @param yMm what is in the middle
 * @param upDeg the direction on the floor that points up; 90 has x to the right
 * @param width of the component, pixels
 * @param height of the component, pixels
 */
public record MapView(double pxPerMm, double xMm, double yMm, double upDeg, int width, int height) {
    /** Value of {@code upDeg} with x to the right and y up. */
    public static final double Y_UP = 90;

    private static final double SMALLEST = 0.002;
    private static final double LARGEST = 2;

    /** Limits the scale to its range. */
    public MapView {
        pxPerMm = Math.max(SMALLEST, Math.min(LARGEST, pxPerMm));
    }

    /**
     * Returns the largest view, y up, that shows all of an area of the floor.
     *
     * @param extent of the floor, mm
     * @param width of the component, pixels
     * @param height of the component, pixels
     * @return a view with the area in the middle
     */
    public static MapView fitting(Rectangle2D extent, int width, int height) {
        double scale = Math.min(width / extent.getWidth(), height / extent.getHeight());
        return new MapView(scale, extent.getCenterX(), extent.getCenterY(), Y_UP, width, height);
    }

    /**
     * Returns the transform from the floor to the component.
     *
     * @return a new one, for the caller to keep
     */
    public AffineTransform transform() {
        AffineTransform transform = AffineTransform.getTranslateInstance(width / 2.0, height / 2.0);
        transform.scale(pxPerMm, -pxPerMm);
        transform.rotate(Math.toRadians(Y_UP - upDeg));
        transform.translate(-xMm, -yMm);
        return transform;
    }

    /**
     * Returns the pixel of a place.
     *
     * @param placeXMm on the floor
     * @param placeYMm on the floor
     * @return pixels
     */
    public Point2D pixel(double placeXMm, double placeYMm) {
        return transform().transform(new Point2D.Double(placeXMm, placeYMm), null);
    }

    /**
     * Returns the place at a pixel.
     *
     * @param x to the right
     * @param y down
     * @return a place on the floor, mm
     */
    public Point2D place(double x, double y) {
        double right = (x - width / 2.0) / pxPerMm;
        double up = (height / 2.0 - y) / pxPerMm;
        double turn = Math.toRadians(upDeg - Y_UP);
        return new Point2D.Double(
                xMm + right * Math.cos(turn) - up * Math.sin(turn), yMm + right * Math.sin(turn) + up * Math.cos(turn));
    }

    /**
     * Returns the place at a pixel, as a pose.
     *
     * @return mm, with the heading 0
     */
    public Pose pose(Point pixel) {
        Point2D place = place(pixel.x, pixel.y);
        return new Pose(place.getX(), place.getY(), 0);
    }

    /**
     * Returns a pose at the same place with another heading.
     *
     * @param to the pixel to which it heads
     */
    public Pose headed(Pose place, Point to) {
        Pose ahead = pose(to);
        double heading = Math.toDegrees(Math.atan2(ahead.yMm() - place.yMm(), ahead.xMm() - place.xMm()));
        return new Pose(place.xMm(), place.yMm(), heading);
    }

    /**
     * Returns the view scaled by a factor, with the same place at a pixel.
     *
     * @param factor positive; below 1 makes it smaller
     * @param x of the pixel
     * @param y of the pixel
     * @return another view
     */
    public MapView zoomed(double factor, double x, double y) {
        Point2D fixed = place(x, y);
        MapView zoomed = new MapView(pxPerMm * factor, xMm, yMm, upDeg, width, height);
        Point2D slipped = zoomed.place(x, y);
        return zoomed.centred(xMm + fixed.getX() - slipped.getX(), yMm + fixed.getY() - slipped.getY());
    }

    /**
     * Returns the view moved as if dragged.
     *
     * @param rightPx pixels
     * @param downPx pixels
     * @return another view
     */
    public MapView moved(double rightPx, double downPx) {
        Point2D middle = place(width / 2.0 - rightPx, height / 2.0 - downPx);
        return centred(middle.getX(), middle.getY());
    }

    /**
     * Returns the view with another place in the middle.
     *
     * @param newXMm mm
     * @param newYMm mm
     * @return another view
     */
    public MapView centred(double newXMm, double newYMm) {
        return new MapView(pxPerMm, newXMm, newYMm, upDeg, width, height);
    }

    /**
     * Returns the view for a component of another size.
     *
     * @param newWidth pixels
     * @param newHeight pixels
     * @return another view
     */
    public MapView sized(int newWidth, int newHeight) {
        return new MapView(pxPerMm, xMm, yMm, upDeg, newWidth, newHeight);
    }
}
