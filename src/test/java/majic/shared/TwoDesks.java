package majic.shared;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import majic.act.NoActs;
import majic.bot.BotAddress;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
import majic.log.Line;
import majic.log.SessionLog;
import majic.program.SharedMap;
import majic.script.MajicParser;
import majic.script.Session;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.desk.DeskOptions;
import majic.shared.desk.DeskSharing;
import majic.shared.desk.SiteLatch;
import majic.shared.message.Sender;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;

/**
 * The desk desk2 of Bert with the Pioneer, or another robot, of a stepped lab, which it shares over a broker in memory,
 * and other desks that use it, each with a team and a session of its own.
 */
final class TwoDesks implements AutoCloseable {
    final LabRig desk2;
    final MajicBot pioneer;
    final BotEnvironment environment;
    final FakeBroker broker;
    final List<FakeConnection> ofDesk2 = new ArrayList<>();
    final DeskSharing sharing;
    private final String typeAtDesk2;
    private final List<Desk> users = new ArrayList<>();

    TwoDesks() {
        this(LabRig.exact());
    }

    TwoDesks(LabRig lab) {
        this(lab, "pioneer");
    }

    TwoDesks(LabRig lab, String robot) {
        desk2 = lab;
        typeAtDesk2 = robot;
        pioneer = lab.add(robot);
        environment = new BotEnvironment(lab.team().time(), Settings.inMemory());
        broker = new FakeBroker(environment.time());
        sharing = new DeskSharing(
                desk2.team(),
                new DeskOptions("lab", "desk2", "Bert", "MAJIC", Set.of(), false),
                (id, will) -> opened(ofDesk2, ConnectOptions.of(id, environment).withWill(will)),
                new SharedMap(desk2.session().map()));
        sharing.start();
    }

    private BrokerConnection opened(List<FakeConnection> to, ConnectOptions options) {
        FakeConnection connection = broker.open(options);
        to.add(connection);
        return connection;
    }

    /** Adds a desk that uses the Pioneer as its robot 1. */
    Desk user(String desk, String person) {
        Desk user = new Desk(desk, person);
        users.add(user);
        return user;
    }

    Pose truePose() {
        return desk2.truePose(typeAtDesk2);
    }

    /** Lets time pass. */
    void pass(double seconds) throws InterruptedException {
        environment.time().sleep(seconds);
    }

    /** Returns how far the Pioneer moves within a time. */
    double movesWithin(double seconds) throws InterruptedException {
        Pose before = truePose();
        pass(seconds);
        return before.distanceMm(truePose());
    }

    @Override
    public void close() {
        users.forEach(Desk::close);
        sharing.close();
        broker.close();
        desk2.close();
    }

    /** A desk that uses the Pioneer. */
    final class Desk {
        final List<FakeConnection> connections = new ArrayList<>();
        final SharedType type = new SharedType((address, options) -> opened(connections, options));
        final Team team = new Team(environment.time());
        final Session session;
        final MajicBot bot;
        private final MajicParser parser;
        private final List<String> said = Collections.synchronizedList(new ArrayList<>());

        Desk(String name, String person) {
            type.sendAs(() -> Sender.ofThisRun(name, person));
            type.observeSites((connection, address, by) -> new SiteLatch(team, connection, address.site(), by));
            BotFactory factory = new BotFactory(List.of(type), Settings.inMemory());
            session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
            session.addListener(this::hear);
            parser = MajicParser.pipe(session);
            bot = type.create(BotAddress.parse("mqtt://broker/lab/desk2/1"), environment);
            bot.connect();
            team.add(bot, OptionalInt.empty());
        }

        private void hear(Line line) {
            if (line.kind() != Line.Kind.COMMAND) {
                said.add(line.text());
            }
        }

        /** Runs lines of MAJIC Script as a pipe would, and returns the output. */
        List<String> run(String... lines) throws InterruptedException {
            session.flush();
            said.clear();
            for (String line : lines) {
                parser.parseText(line);
            }
            parser.awaitAll();
            return said();
        }

        /** Starts lines without waiting for their end. */
        void say(String... lines) {
            session.flush();
            said.clear();
            for (String line : lines) {
                parser.parseText(line);
            }
        }

        List<String> said() {
            session.flush();
            synchronized (said) {
                return List.copyOf(said);
            }
        }

        Member robot() {
            return team.member(1);
        }

        FakeConnection connection() {
            return connections.get(connections.size() - 1);
        }

        private void close() {
            team.close();
        }
    }
}
