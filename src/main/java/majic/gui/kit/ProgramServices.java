package majic.gui.kit;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import majic.environment.Settings;
import majic.recorder.RecordedHistory;
import majic.recorder.Recorder;
import majic.recorder.RecordingFolder;
import org.jspecify.annotations.Nullable;

/**
 * Holds what the program provides to the window. Immutable.
 *
 * @param serialPorts lists the serial ports of this computer; may block, so it is called in the background, and throws
 *     a {@link majic.bot.BotException} if they cannot be listed
 * @param startLab starts a simulated lab and has the factory use it; may block and throw a
 *     {@link majic.bot.BotException}; null if there is none to start
 * @param quit stops and closes everything and ends the program; may block, is called once, in the background
 * @param settings the stored settings
 * @param recordings the recordings of this and earlier sessions
 * @param recorder what records this session; null if it is not recorded
 * @param history the file of the command line's earlier lines; null if they are not kept
 * @param sharing shares the robots with other desks; null if that is not possible
 */
public record ProgramServices(
        Supplier<List<SerialPortChoice>> serialPorts,
        @Nullable Runnable startLab,
        Runnable quit,
        Settings settings,
        RecordingFolder recordings,
        @Nullable Recorder recorder,
        @Nullable Path history,
        @Nullable RobotSharing sharing) {
    /** Returns what was recorded in this session; null if it is not recorded. */
    public @Nullable RecordedHistory recorded() {
        return recorder == null ? null : recorder.history();
    }

    /**
     * A serial port to choose.
     *
     * @param name as in an address: {@code COM3}, {@code /dev/ttyUSB0}; one that stays, if the port has one
     * @param text the name with what the system says about the device
     */
    public record SerialPortChoice(String name, String text) {
        @Override
        public String toString() {
            return text;
        }
    }
}
