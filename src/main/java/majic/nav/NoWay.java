package majic.nav;

import majic.bot.MotionFailed;

/** The place cannot be reached at present, though the robot could drive. */
final class NoWay extends MotionFailed {
    private static final long serialVersionUID = 1;

    NoWay(String message) {
        super(message);
    }
}
