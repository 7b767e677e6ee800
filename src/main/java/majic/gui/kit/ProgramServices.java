package majic.gui.kit;

import java.util.List;
import java.util.function.Supplier;
import majic.bot.Settings;
import org.jspecify.annotations.Nullable;

/**
 * Holds what the program provides to the window. Immutable.
 *
 * @param serialPorts lists the serial ports of this computer; may block, so it is called in the background
 * @param startLab starts a simulated lab and has the factory use it; may block and throw a
 *     {@link majic.bot.BotException}; null if there is none to start
 * @param quit stops and closes everything and ends the program; may block, is called once, in the background
 * @param settings the stored settings
 */
public record ProgramServices(
        Supplier<List<SerialPortChoice>> serialPorts,
        @Nullable Runnable startLab,
        Runnable quit,
        Settings settings) {

    /**
     * A serial port to choose.
     *
     * @param name as in an address: {@code COM3}, {@code /dev/ttyUSB0}
     * @param description the system's name of the device; may be empty
     */
    public record SerialPortChoice(String name, String description) {
        @Override
        public String toString() {
            return description.isEmpty() ? name : name + "  (" + description + ")";
        }
    }
}
