package majic.gui.replay;

import java.util.List;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.recorder.RecordedRobot;
import majic.text.Texts;

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

    /** The type of a recorded robot of which no driver is installed. */
    private record RecordedType(String name, String label, String make) implements BotType {
        private static final Texts TEXTS = Texts.of(RecordedType.class);

        RecordedType(RecordedRobot robot) {
            this(robot.type(), robot.label(), robot.make());
        }

        @Override
        public List<Reach> reaches() {
            return List.of(Reach.TCP);
        }

        @Override
        public int defaultPort(String scheme) {
            return 0;
        }

        @Override
        public MajicBot create(BotAddress address, BotEnvironment environment) {
            throw new BotException(TEXTS.get("noDriver", name));
        }

        @Override
        public String advice() {
            return "";
        }
    }
}
