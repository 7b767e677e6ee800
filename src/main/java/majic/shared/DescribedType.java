package majic.shared;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.shared.message.Description;

/**
 * The type of a shared robot that has been connected: that of the robot at its desk, so that acts, scripts and users
 * treat it as a robot of this type.
 *
 * @param shared the type by whose addresses it is reached
 * @param kind the type that the desk has published
 * @param desk the desk that has the robot
 */
record DescribedType(SharedType shared, Description.Kind kind, String desk) implements BotType {
    @Override
    public String name() {
        return kind.type();
    }

    /** Also by the scheme of its address: it is a shared robot as well. */
    @Override
    public boolean isMeantBy(String scheme) {
        return BotType.super.isMeantBy(scheme) || shared.isMeantBy(scheme);
    }

    @Override
    public String label() {
        return kind.label() + " (" + desk + ")";
    }

    @Override
    public String make() {
        return kind.make() + " (" + desk + ")";
    }

    @Override
    public List<Reach> reaches() {
        return shared.reaches();
    }

    @Override
    public int defaultPort(String scheme) {
        return shared.defaultPort(scheme);
    }

    @Override
    public MajicBot create(BotAddress address, BotEnvironment environment) {
        return shared.create(address, environment);
    }

    @Override
    public String replayedBy() {
        return shared.name();
    }

    @Override
    public ReplayDisplay replay(MajicBot recorded) {
        return shared.replay(recorded);
    }

    @Override
    public String advice() {
        return shared.advice();
    }
}
