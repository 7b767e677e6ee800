package majicsim.world;

/**
 * What a ray meets first. If it meets nothing, {@link #found()} is false, the distance is the length of the ray and the
 * reflectivity is 0.
 *
 * @param distanceMm mm from the ray's start
 * @param incidenceDeg 0 (square on) to 90 (grazing)
 * @param reflectivity of the surface; white paper is 1; always above 0 when something was met
 */
public record Hit(double distanceMm, double incidenceDeg, double reflectivity) {

    static Hit nothing(double maxMm) {
        return new Hit(maxMm, 0, 0);
    }

    /**
     * Whether the ray met something.
     *
     * @return false if it ended in the air
     */
    public boolean found() {
        return reflectivity > 0;
    }
}
