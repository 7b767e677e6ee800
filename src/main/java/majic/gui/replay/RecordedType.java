package majic.gui.replay;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.recorder.RecordedRobot;
import majic.text.Texts;

/** The type of a recorded robot of which no driver is installed. */
record RecordedType(String name, String label, String make) implements BotType {
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
