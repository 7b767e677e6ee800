package majicsim.aibo.scene;

/**
 * The surface that one ray hits.
 *
 * @param what the kind of surface
 * @param levelMm its distance, measured on the floor
 * @param heightMm its height above the floor
 * @param slant cosine of the angle of incidence, 1 perpendicular
 * @param reflectivity of a wall, white paper is 1; 1 for everything else
 * @param rgb the colour of a robot; 0 for everything else
 */
public record VisibleSurface(Kind what, double levelMm, double heightMm, double slant, double reflectivity, int rgb) {
    /** Kinds of surfaces. */
    enum Kind {
        WALL,
        FLOOR,
        CEILING,
        ROBOT,
        HAZE
    }

    static VisibleSurface of(Kind what, double levelMm, double heightMm) {
        return new VisibleSurface(what, levelMm, heightMm, 1, 1, 0);
    }
}
