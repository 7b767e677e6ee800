package majic.gui.kit;

import java.util.Optional;

/**
 * Sharing of the team's robots with other desks over a broker, as the program provides it to the window. Thread-safe.
 */
public interface RobotSharing {
    /**
     * Where robots are shared, and under which names.
     *
     * @param broker the address of the broker with the site, such as {@code mqtt://broker/lab}
     * @param desk the name of this desk
     * @param person the name of the user that others see; may be empty
     */
    record Place(String broker, String desk, String person) {}

    /** Returns where the robots were shared last; otherwise names made from this computer, and no broker. */
    Place suggested();

    /** Returns where the robots are shared; empty if they are not. */
    Optional<Place> now();

    /** Returns whether others can reach the robots; false while the broker is gone. */
    boolean isConnected();

    /**
     * Begins to share all robots of the team. Blocks for at most 13 s.
     *
     * @throws majic.bot.BotException if the broker cannot be reached or another desk has the name, or the robots are
     *     shared already; nothing is shared then
     */
    void start(Place place);

    /**
     * Uses a user name and a password for a broker from now on, until the program ends.
     *
     * @param broker the address, as in a place
     * @throws majic.bot.BotException if it is no address
     */
    void useLogin(String broker, String user, char[] password);

    /**
     * Ends the sharing; robots that others move are halted first. Blocks for about a second. No effect if there is
     * none.
     */
    void stop();
}
