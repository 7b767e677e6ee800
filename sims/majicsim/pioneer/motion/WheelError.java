package majicsim.pioneer.motion;

import majicsim.world.Noise;

/**
 * The error of the wheels: how far the robot truly goes and turns for each mm and degree that its encoders count. Fixed
 * for the life of a robot, like worn tyres and a wheel distance that is not quite what the controller assumes.
 *
 * @param way true mm for each mm counted
 * @param turn true degrees for each degree counted
 */
record WheelError(double way, double turn) {
    static final WheelError NONE = new WheelError(1, 1);

    /** Draws 1 to 2 % for distance and 2 to 5 % for turning, of either sign; none from an exact source. */
    static WheelError draw(Noise noise) {
        if (noise.isExact()) {
            return NONE;
        }
        return new WheelError(1 + signed(noise, 0.01, 0.02), 1 + signed(noise, 0.02, 0.05));
    }

    private static double signed(Noise noise, double from, double to) {
        double size = noise.uniform(from, to);
        return noise.chance(0.5) ? size : -size;
    }
}
