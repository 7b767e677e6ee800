package majic.aibo.urbi;

import majic.bot.BotException;

/** A question that the dog answered with an error, or not at all. */
public final class UrbiRefusal extends BotException {
    private static final long serialVersionUID = 1;

    public UrbiRefusal(String message) {
        super(message);
    }
}
