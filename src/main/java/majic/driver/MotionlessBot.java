package majic.driver;

import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotType;
import majic.bot.Range;
import majic.bot.Value;
import majic.environment.BotEnvironment;

/** A robot that has no link and refuses every motion, such as a recorded one. */
public abstract class MotionlessBot extends BotDriver {
    /** Needed by a profile; no motion is ever accepted. */
    private static final Range ANY_SPEED = new Range(-1, 1);

    private final String refusal;

    /**
     * Creates a robot that is not connected.
     *
     * @param type the kind of robot
     * @param bodyMm the radius of a circle that it fits into, mm, above 0
     * @param estimates whether its pose is estimated
     * @param environment the clock and the settings
     * @param refusal the sentence with which every motion is refused
     */
    protected MotionlessBot(
            BotType type, double bodyMm, boolean estimates, BotEnvironment environment, String refusal) {
        super(type, new BotProfile(bodyMm, ANY_SPEED, ANY_SPEED, 1, 1, 1, estimates), environment);
        this.refusal = refusal;
    }

    /**
     * Returns the reason why it does nothing, to throw it.
     *
     * @return a new exception
     */
    protected final BotException refusal() {
        return new BotException(refusal);
    }

    @Override
    protected void open() {}

    @Override
    protected void shut() {}

    @Override
    protected final Value moveBy(double mm, Motion motion) {
        throw refusal();
    }

    @Override
    protected final Value turnBy(double degrees, Motion motion) {
        throw refusal();
    }

    @Override
    protected final void driveAt(double mmPerSec, double degPerSec) {
        throw refusal();
    }

    @Override
    protected final void halt() {}
}
