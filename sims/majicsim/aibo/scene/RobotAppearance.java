package majicsim.aibo.scene;

import java.util.Map;
import majicsim.world.Body;

/**
 * How a robot appears in the dog's camera: an upright block of one colour.
 *
 * @param heightMm of its top above the floor
 * @param rgb its colour
 */
record RobotAppearance(double heightMm, int rgb) {
    private static final RobotAppearance STRANGER = new RobotAppearance(300, 0xE0A030);
    private static final Map<String, RobotAppearance> KNOWN = Map.of(
            "pioneer", new RobotAppearance(240, 0xC02020),
            "hemisson", new RobotAppearance(70, 0x30A040),
            "aibo", new RobotAppearance(270, 0xE8E8F0));

    static RobotAppearance of(Body body) {
        return KNOWN.getOrDefault(body.name(), STRANGER);
    }
}
