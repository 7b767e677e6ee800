package majicsim.world;

/** A strong lamp some 40 cm above the floor; what it adds falls off with the distance on the floor. */
record Lamp(double xMm, double yMm) {
    private static final double HEIGHT_MM = 400;
    private static final double STRENGTH = 0.85;

    double lightAt(double x, double y) {
        double ratio = Math.hypot(x - xMm, y - yMm) / HEIGHT_MM;
        double spread = 1 + ratio * ratio;
        return STRENGTH / (spread * spread);
    }
}
