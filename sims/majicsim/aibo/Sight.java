package majicsim.aibo;

/**
 * What is seen along one ray.
 *
 * @param what the kind of surface
 * @param levelMm how far off it is, measured on the floor
 * @param heightMm its height above the floor
 * @param slant cosine of the angle at which it is met, 1 square on
 * @param reflectivity of a wall, white paper is 1; 1 of everything else
 * @param rgb the colour of a robot; 0 of everything else
 */
record Sight(Kind what, double levelMm, double heightMm, double slant, double reflectivity, int rgb) {
    /** Kinds of surfaces. */
    enum Kind {
        WALL,
        FLOOR,
        CEILING,
        ROBOT,
        HAZE
    }

    static Sight of(Kind what, double levelMm, double heightMm) {
        return new Sight(what, levelMm, heightMm, 1, 1, 0);
    }
}
