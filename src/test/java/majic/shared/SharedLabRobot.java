package majic.shared;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import majic.bot.BotAddress;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.TestedRobot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRobot;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.desk.DeskOptions;
import majic.shared.desk.DeskSharing;
import majic.team.Team;

/**
 * A robot of an exact lab, which a desk shares over a broker in memory, and the driver by which another desk uses it.
 */
final class SharedLabRobot implements TestedRobot {
    private final LabRobot local;
    private final BotEnvironment environment;
    private final FakeBroker broker;
    private final List<FakeConnection> ofDesk = new ArrayList<>();
    private final List<FakeConnection> ofUser = new ArrayList<>();
    private final Team team;
    private final DeskSharing sharing;
    private final SharedType type = new SharedType((address, options) -> open(ofUser, options));
    private final MajicBot bot;

    /** Creates a lab; the desk is connected to the robot, the driver is not. */
    SharedLabRobot(String typeAtDesk) {
        local = new LabRobot(typeAtDesk);
        environment = new BotEnvironment(local.bot().time(), Settings.inMemory());
        broker = new FakeBroker(environment.time());
        team = new Team(environment.time());
        local.bot().connect();
        team.add(local.bot(), OptionalInt.empty());
        DeskOptions options = new DeskOptions("lab", "desk2", "Bert", "MAJIC", Set.of(), false);
        sharing = new DeskSharing(
                team,
                options,
                (id, will) -> open(ofDesk, ConnectOptions.of(id, environment).withWill(will)));
        sharing.start();
        bot = type.create(BotAddress.parse("mqtt://broker/lab/desk2/1"), environment);
    }

    private BrokerConnection open(List<FakeConnection> to, ConnectOptions options) {
        FakeConnection opened = broker.open(options);
        to.add(opened);
        return opened;
    }

    @Override
    public MajicBot bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        return local.truePose();
    }

    @Override
    public void cut() {
        ofUser.get(ofUser.size() - 1).drop();
    }

    @Override
    public void fallSilent() {
        ofDesk.get(0).holdBack();
    }

    /** Keeps everything from and to the program that uses the robot on its way. */
    void holdUserBack() {
        ofUser.get(ofUser.size() - 1).holdBack();
    }

    /** Delivers it at once. */
    void deliverToUser() {
        ofUser.get(ofUser.size() - 1).deliver();
    }

    @Override
    public void block() {
        local.block();
    }

    @Override
    public void unblock() {
        local.unblock();
    }

    @Override
    public void close() {
        bot.close();
        sharing.close();
        team.close();
        broker.close();
        local.close();
    }
}
