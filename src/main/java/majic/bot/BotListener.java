package majic.bot;

import java.util.function.Supplier;

/**
 * Is called with news of a robot: one event after the other, on the robot's listener thread or on a thread that
 * commands it. A listener that blocks holds up the robot's other listeners and perhaps the command that caused the
 * event, but no stop and nothing the robot reports. Asking the robot for what it does not report by itself may give
 * {@code unknown}.
 */
public interface BotListener {
    /**
     * New readings arrived. If several arrive before the listener is called, only the newest is delivered.
     *
     * @param bot the robot
     * @param state the readings common to all robots; read the others from the robot
     */
    default void stateChanged(MajicBot bot, BotState state) {}

    /**
     * The connection changed. {@link MajicBot#connect()} and {@link MajicBot#close()} return after all listeners have
     * received the change. They wait for a second at most while a listener blocks another thread, and not at all if
     * they are called by a listener or on a thread that reads a link or runs a robot's timer.
     *
     * @param bot the robot
     * @param connection what it is now
     */
    default void connectionChanged(MajicBot bot, MajicBot.Connection connection) {}

    /**
     * The driver sent a notice to the user: motors were switched on, which gait it chose.
     *
     * @param bot which robot
     * @param message one sentence or half of one
     */
    default void notice(MajicBot bot, String message) {}

    /**
     * A picture of the robot's camera arrived, because something asked for it.
     *
     * @param bot which robot
     * @param jpeg makes a JPEG file of it; blocks for some milliseconds
     */
    default void pictureTaken(MajicBot bot, Supplier<byte[]> jpeg) {}
}
