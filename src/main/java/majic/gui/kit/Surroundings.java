package majic.gui.kit;

import java.util.List;
import java.util.function.Supplier;
import majic.bot.Settings;
import org.jspecify.annotations.Nullable;

/**
 * What the window is given by the program around it. Immutable.
 *
 * @param serialPorts finds the serial ports of this machine; may wait, so it is asked in the background
 * @param startLab starts a simulated lab and has the factory use it; may wait and throw a
 *     {@link majic.bot.BotException}; null if there is none to start
 * @param quit stops and closes everything and ends the program; may wait, is called once, in the background
 * @param settings what is remembered from one start to the next
 */
public record Surroundings(
        Supplier<List<SerialPortChoice>> serialPorts,
        @Nullable Runnable startLab,
        Runnable quit,
        Settings settings) {

    /**
     * A serial port to choose.
     *
     * @param name as in an address: {@code COM3}, {@code /dev/ttyUSB0}
     * @param description what the system calls the thing behind it; may be empty
     */
    public record SerialPortChoice(String name, String description) {
        @Override
        public String toString() {
            return description.isEmpty() ? name : name + "  (" + description + ")";
        }
    }
}
