package majicsim.world;

/**
 * What a ray meets first. If it meets nothing, {@link #found()} is false, the distance is the length of the ray and the
 * reflectivity is 0.
 *
 * @param distanceMm mm from the ray's start
 * @param squareness the cosine of the angle of incidence: 1 (square on) to 0 (grazing); 1 if nothing was met
 * @param reflectivity of the surface; white paper is 1; always above 0 when something was met
 */
public record Hit(double distanceMm, double squareness, double reflectivity) {

    /**
     * Whether the ray met something.
     *
     * @return false if it ended in the air
     */
    public boolean found() {
        return reflectivity > 0;
    }
}
