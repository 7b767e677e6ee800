package majic.aibo;

import java.util.List;
import majic.aibo.panel.AiboReplay;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;

/** The Sony Aibo ERS-7 with URBI on its stick. */
public final class AiboType implements BotType {
    /** The port an URBI server listens at (URBI sheet 2). */
    public static final int PORT = 54_000;

    /** Made by the service loader. */
    public AiboType() {}

    @Override
    public String name() {
        return "aibo";
    }

    @Override
    public String label() {
        return "Aibo";
    }

    @Override
    public String make() {
        return "Sony Aibo ERS-7";
    }

    @Override
    public List<Reach> reaches() {
        return List.of(Reach.TCP);
    }

    @Override
    public int defaultPort(String scheme) {
        return PORT;
    }

    @Override
    public List<String> libraries() {
        return AiboTransports.LIBRARIES;
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return new MajicAibo(address, environment);
    }

    @Override
    public String advice() {
        return "Is the dog switched on, with the URBI stick in it and its wireless light on? From this computer "
                + "\"telnet HOST 54000\" should show lines that start with a number in brackets.";
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return new AiboReplay(recorded);
    }
}
