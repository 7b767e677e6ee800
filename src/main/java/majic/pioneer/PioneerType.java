package majic.pioneer;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.pioneer.panel.PioneerReplay;

/** The Pioneer among the types of robots. */
public final class PioneerType implements BotType {
    /** Where robots, their bridges and the vendor's simulator listen (ARCOS sheet 1). */
    static final int PORT = 8101;

    /** Made by the service loader. */
    public PioneerType() {}

    @Override
    public String name() {
        return "pioneer";
    }

    @Override
    public String label() {
        return "Pioneer";
    }

    @Override
    public String make() {
        return "MobileRobots Pioneer";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP, Reach.SERIAL);
    }

    @Override
    public int defaultPort(String scheme) {
        return PORT;
    }

    @Override
    public List<String> libraries() {
        return PioneerConnections.LIBRARIES;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return new MajicPioneer(address, environment);
    }

    @Override
    public String advice() {
        return "Is the robot switched on, its serial cable or network bridge plugged in, and no other program connected"
                + " to it? A Pioneer talks to one program at a time; its network port is usually 8101.";
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new PioneerReplay(recorded);
    }
}
