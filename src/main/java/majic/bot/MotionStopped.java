package majic.bot;

/** A motion was ended before its time by a stop, or was not begun because of one. The robot was told to stand. */
public class MotionStopped extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * A stopped motion.
     *
     * @param message who or what stopped it; just "stopped" after a plain stop
     */
    public MotionStopped(String message) {
        super(message);
    }
}
