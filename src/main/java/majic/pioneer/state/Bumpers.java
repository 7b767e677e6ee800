package majic.pioneer.state;

import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import org.jspecify.annotations.Nullable;

/**
 * The bumper segments that a robot has; other bits have no meaning. Immutable.
 *
 * @param frontSegments 0 to 7
 * @param rearSegments 0 to 7
 */
public record Bumpers(int frontSegments, int rearSegments) {

    /** Those that the robot reports, else those that its model has from the factory. */
    public static Bumpers of(Model model, @Nullable Config config) {
        return config == null || !config.isKnown(ConfigField.FRONTBUMPS)
                ? new Bumpers(model.frontBumpers(), model.rearBumpers())
                : new Bumpers(config.frontBumpers(), config.rearBumpers());
    }

    /** The touched segments as bits. */
    public int front(PioneerState now) {
        return now.frontBumpers() & (1 << frontSegments) - 1;
    }

    /** The touched segments as bits. */
    public int rear(PioneerState now) {
        return now.rearBumpers() & (1 << rearSegments) - 1;
    }

    public boolean touched(PioneerState now) {
        return front(now) != 0 || rear(now) != 0;
    }
}
