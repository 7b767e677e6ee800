package majic.bot;

/** Hears of a robot. Called on the driver's own threads: be quick, and cross over to another thread for anything slow. */
public interface BotListener {
    /**
     * New readings arrived.
     *
     * @param bot whose
     * @param state what it shares with all robots; ask the robot for the rest
     */
    default void stateChanged(MajicBot bot, BotState state) {}

    /**
     * The connection changed.
     *
     * @param bot whose
     * @param connection what it is now
     */
    default void connectionChanged(MajicBot bot, MajicBot.Connection connection) {}

    /**
     * The driver has something to say to the person: motors were switched on, which gait it chose.
     *
     * @param bot which robot
     * @param message one sentence or half of one
     */
    default void notice(MajicBot bot, String message) {}
}
