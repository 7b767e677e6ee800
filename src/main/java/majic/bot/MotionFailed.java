package majic.bot;

/** The robot ended a motion by itself: a stall, a bumper, motors switched off. A stop was sent. */
public class MotionFailed extends BotException {
    private static final long serialVersionUID = 1;

    /**
     * A failed motion.
     *
     * @param message the reason, as half a sentence: "stalled after 120 mm"
     */
    public MotionFailed(String message) {
        super(message);
    }
}
