package majicsim.aibo;

import java.util.Map;
import majicsim.world.Body;

/**
 * How a robot appears in the dog's camera: an upright block of one colour.
 *
 * @param heightMm of its top above the floor
 * @param rgb its colour
 */
record Appearance(double heightMm, int rgb) {
    private static final Appearance STRANGER = new Appearance(300, 0xE0A030);
    private static final Map<String, Appearance> KNOWN = Map.of(
            "pioneer", new Appearance(240, 0xC02020),
            "hemisson", new Appearance(70, 0x30A040),
            "aibo", new Appearance(270, 0xE8E8F0));

    static Appearance of(Body body) {
        return KNOWN.getOrDefault(body.name(), STRANGER);
    }
}
