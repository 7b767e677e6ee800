package majicsim.world;

/**
 * Where around its outline a body touches a wall or another body.
 *
 * @param touching false if it touches nothing; the direction is then 0 and means nothing
 * @param directionDeg from the turning centre to the place of contact, in the body's frame: 0 ahead, 90 left, 180
 *     behind
 */
public record Contact(boolean touching, double directionDeg) {
    /** Touches nothing. */
    public static final Contact NONE = new Contact(false, 0);
}
