package majic.hemisson;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.hemisson.panel.HemissonReplay;

/** K-Team's Hemisson, on a serial port or behind a serial server. */
public final class HemissonType implements BotType {
    /** Used by the service loader. */
    public HemissonType() {}

    @Override
    public String name() {
        return "hemisson";
    }

    @Override
    public String label() {
        return "Hemisson";
    }

    @Override
    public String make() {
        return "K-Team Hemisson";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.SERIAL, Reach.TCP);
    }

    /** 0, because serial servers have no usual port. */
    @Override
    public int defaultPort(String scheme) {
        return 0;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return new MajicHemisson(address, environment);
    }

    @Override
    public String advice() {
        return "Is the robot on, in the Exec position, with all four top switches to the same side, and is it this port? "
                + "A Hemisson that was sent characters too fast receives nothing any more: switch it off, wait 5 s and switch it on.";
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new HemissonReplay(recorded);
    }
}
