package majicsim.world;

/**
 * A bulb under a shade, 40 cm above the floor; it is no obstacle. Its light decreases with the square of the distance
 * and ends where its shade ends.
 *
 * @param at its place on the floor
 */
public record Lamp(Point at) {
    /** How far it shines. */
    public static final double REACH_MM = 2500;

    private static final double HEIGHT_MM = 400;
    private static final double STRENGTH_MM2 = 350_000;
    private static final double BRIGHTEST = 0.85;

    /** The light at a place without a direction, including that from floor and walls. */
    private static final double SCATTERED = 0.25;

    /** The light at a place from all directions, 0 to 0.85. */
    double lightAt(Point place) {
        return Math.min(BRIGHTEST, lightMm(place.distanceTo(at)));
    }

    /** The light on a level sensor, by its direction; at most 1.4. */
    double lightOn(Pose sensor) {
        double mm = at.distanceTo(new Point(sensor.xMm(), sensor.yMm()));
        double level = mm / Math.hypot(mm, HEIGHT_MM);
        Point seen = sensor.toLocal(at);
        double aside = Math.atan2(seen.yMm(), seen.xMm());
        return lightMm(mm) * (SCATTERED + (1 - SCATTERED) * level * Math.max(0, Math.cos(aside)));
    }

    double scatteredAt(Point place) {
        return SCATTERED * lightMm(place.distanceTo(at));
    }

    private static double lightMm(double mm) {
        double part = mm / REACH_MM;
        return part >= 1 ? 0 : STRENGTH_MM2 / (HEIGHT_MM * HEIGHT_MM + mm * mm) * (1 - part * part);
    }
}
