package majic.gui.drive;

/** A game controller. All methods are called by one thread, and may block it. */
public interface Gamepad extends AutoCloseable {
    /** Opens the game controllers of this computer. */
    @FunctionalInterface
    interface Opener {
        /**
         * Loads what is needed to read game controllers.
         *
         * @throws majic.bot.BotException if none can be read on this computer, saying why
         */
        Gamepad open();
    }

    /** Reads the first connected controller; {@link GamepadState#UNPLUGGED} while there is none. */
    GamepadState read();

    @Override
    void close();
}
