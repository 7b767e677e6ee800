package majic.bot;

/** A motion was ended before its time by a stop, or was not begun because of one. A stop was sent to the robot. */
public class MotionStopped extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * A stopped motion.
     *
     * @param message the cause of the stop; just "stopped" after a plain stop
     */
    public MotionStopped(String message) {
        super(message);
    }
}
