package majic.act;

import java.util.List;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.nav.CurrentMap;

/** Receives the events of a running act, on the act's thread. */
interface ActListener {
    /**
     * Receives a note on what the act is doing.
     *
     * @param words the act's note
     */
    void said(String words);

    /**
     * Shows readings of the act's robots as curves; without a window it is refused.
     *
     * @param parameters their names
     * @throws BotException if they cannot be shown
     */
    default void plot(List<String> parameters) {
        throw new BotException("a plot needs the window of MAJIC, which is not open");
    }

    /** Returns the map of the team, with what sends its robots to places. */
    CurrentMap map();

    /**
     * Returns a robot of the team, which the act only looks at.
     *
     * @param name its number or name
     * @throws BotException if there is none
     */
    default MajicBot teamMate(String name) {
        throw new BotException("an act that runs outside of a session has no team, so no robot " + name);
    }

    /** Receives the end of the act, after its clean-up; the act can no longer use a robot. */
    void ended();
}
