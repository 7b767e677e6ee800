package majicsim.pioneer.motion;

import majicsim.pioneer.model.PioneerModel;

/**
 * The limits of both motion channels. Immutable.
 *
 * @param translation in mm
 * @param rotation in degrees
 */
public record MotionLimits(Limits translation, Limits rotation) {
    /** What the CONFIG packet states as tops of accelerations: no motor of any model comes near (ARCOS sheet 10). */
    private static final double TOP_ACCELERATION = 9999;

    private static final double STORED_SPEED = 3000;
    private static final double STORED_TURN = 150;
    private static final double STORED_ACCELERATION = 300;
    private static final double STORED_TURN_ACCELERATION = 100;

    /** The highest values of the model, which no command can exceed. */
    public static MotionLimits tops(PioneerModel model) {
        return new MotionLimits(
                new Limits(model.topSpeedMmPerSec(), TOP_ACCELERATION, TOP_ACCELERATION),
                new Limits(model.topTurnDegPerSec(), TOP_ACCELERATION, TOP_ACCELERATION));
    }

    /** The limits at the start of every session (ARCOS sheet 5.1; values of sheet 10). */
    public static MotionLimits stored(PioneerModel model) {
        MotionLimits tops = tops(model);
        return new MotionLimits(
                tops.capTranslation(new Limits(STORED_SPEED, STORED_ACCELERATION, STORED_ACCELERATION)),
                tops.capRotation(new Limits(STORED_TURN, STORED_TURN_ACCELERATION, STORED_TURN_ACCELERATION)));
    }

    Limits capTranslation(Limits wanted) {
        return wanted.cappedBy(translation);
    }

    Limits capRotation(Limits wanted) {
        return wanted.cappedBy(rotation);
    }
}
