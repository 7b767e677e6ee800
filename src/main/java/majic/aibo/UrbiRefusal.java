package majic.aibo;

import majic.bot.BotException;

/** A question that the dog answered with an error, or not at all. */
final class UrbiRefusal extends BotException {
    private static final long serialVersionUID = 1;

    UrbiRefusal(String message) {
        super(message);
    }
}
