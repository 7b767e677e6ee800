package majic.shared.broker;

import majic.bot.BotException;

/** The broker has refused a message, mostly because the user has no right to publish on its topic. */
public final class PublicationRefused extends BotException {
    private static final long serialVersionUID = 1;

    private final String reason;

    /**
     * Creates the exception.
     *
     * @param topic of the message
     * @param reason as the broker gives it
     */
    public PublicationRefused(String topic, String reason) {
        super("the broker did not take the message on " + topic + ": " + reason);
        this.reason = reason;
    }

    /**
     * Returns why.
     *
     * @return as the broker gives it: {@code not authorized}
     */
    public String reason() {
        return reason;
    }
}
