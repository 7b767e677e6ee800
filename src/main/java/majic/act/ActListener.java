package majic.act;

import java.util.List;
import java.util.Optional;
import majic.bot.BotException;
import majic.nav.grid.NavigationMap;

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

    /** Returns the map of the team; empty if there is none. */
    default Optional<NavigationMap> map() {
        return Optional.empty();
    }

    /** Receives the end of the act, after its clean-up; the act can no longer use a robot. */
    void ended();
}
