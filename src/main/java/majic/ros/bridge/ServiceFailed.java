package majic.ros.bridge;

import majic.bot.BotException;

/** A service of a robot could not be called, or reported a failure. */
public final class ServiceFailed extends BotException {
    private static final long serialVersionUID = 1;

    private final boolean answered;

    ServiceFailed(String message, boolean answered) {
        super(message);
        this.answered = answered;
    }

    /**
     * Returns whether the server answered.
     *
     * @return true for a failure that the server reported; false if nothing came in time
     */
    public boolean isAnswered() {
        return answered;
    }
}
