package majic.shared.desk;

import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.FakeBot;
import majic.driver.BotDriver;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.nav.CurrentMap;
import majic.program.SharedMap;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.team.Answer;
import majic.team.Team;
import majic.team.TeamListener;

/** A broker, and a desk with made-up robots that shares them, on one stepped clock, for one test. */
final class SharingRig implements AutoCloseable {
    static final String SITE = "lab";
    static final String DESK = "desk2";

    final TestClock clock = new TestClock();
    final FakeBroker broker = new FakeBroker(clock.time());
    final Team team = new Team(clock.time());
    final List<String> said = new CopyOnWriteArrayList<>();
    final List<FakeConnection> connections = new CopyOnWriteArrayList<>();
    final DeskSharing sharing = sharing(DESK, team);

    SharingRig() {
        team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String message) {
                said.add(message);
            }

            @Override
            public void latchChanged(boolean latched) {
                if (latched) {
                    said.add(team.latchText());
                }
            }

            @Override
            public void answered(Answer answer) {
                said.add(answer.text());
            }
        });
    }

    /** A rig that shares one robot. */
    static SharingRig started() {
        SharingRig rig = new SharingRig();
        rig.add();
        rig.sharing.start();
        return rig;
    }

    /** Another desk with a team of its own, or the same desk once more. */
    DeskSharing sharing(String desk, Team of) {
        return new DeskSharing(
                of,
                new DeskOptions(SITE, desk, "Bob", "MAJIC test", Set.of(), false),
                this::open,
                new SharedMap(new CurrentMap((robot, news) -> {})));
    }

    FakeConnection open(String clientId, BrokerMessage will) {
        FakeConnection connection =
                broker.open(ConnectOptions.of(clientId, new BotEnvironment(clock.time(), Settings.inMemory()))
                        .withWill(will));
        connections.add(connection);
        return connection;
    }

    /** The connection of the desk with the broker. */
    FakeConnection connection() {
        return connections.get(0);
    }

    FakeBot add() {
        FakeBot bot = FakeBot.on(clock.time());
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }

    /** Returns robot 1. */
    FakeBot bot() {
        return (FakeBot) BotDriver.of(team.member(1).bot());
    }

    /** A user of the desk's robots at another desk. */
    RemoteUser user(String desk, String person) {
        return new RemoteUser(this, desk, person);
    }

    void sleep(double seconds) {
        try {
            clock.time().sleep(seconds);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    boolean isSaid(String part) {
        return said.stream().anyMatch(line -> line.contains(part));
    }

    @Override
    public void close() {
        sharing.close();
        team.close();
        broker.close();
        clock.close();
    }
}
