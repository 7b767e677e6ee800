package majic.shared.panel;

import majic.bot.BotException;

/** Requests pictures of the camera of a shared robot. */
@FunctionalInterface
public interface SharedPictures {
    /**
     * Requests a picture. Blocks; not for the event dispatch thread.
     *
     * @return a JPEG file
     * @throws BotException if there is none; the message says why
     */
    byte[] request();
}
