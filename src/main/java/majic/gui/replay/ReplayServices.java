package majic.gui.replay;

import java.util.List;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.bot.BotType;
import majic.environment.Settings;
import majic.recorder.RecordedRobot;

/**
 * What a replay needs of the program. Immutable.
 *
 * @param settings keep the folder of the last file
 * @param types the types of robots of which panels can be shown
 * @param stopButtons makes a button that stops the team, for each window
 */
public record ReplayServices(Settings settings, List<BotType> types, Supplier<? extends JComponent> stopButtons) {
    /** The type of a recorded robot; one without a panel if it is not installed. */
    BotType type(RecordedRobot robot) {
        return types.stream()
                .filter(type -> type.name().equals(robot.type()))
                .findFirst()
                .orElseGet(() -> new RecordedType(robot));
    }
}
