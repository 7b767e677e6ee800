package majic.act;

import java.util.List;

/** Receives the events of a running act, on the act's thread. */
interface ActListener {
    /**
     * Receives a note on what the act is doing.
     *
     * @param words the act's note
     */
    void said(String words);

    /**
     * Shows readings of the act's robots as curves.
     *
     * @param parameters their names
     * @throws majic.bot.BotException if they cannot be shown
     */
    void plot(List<String> parameters);

    /** Receives the end of the act, after its clean-up; the act can no longer use a robot. */
    void ended();
}
