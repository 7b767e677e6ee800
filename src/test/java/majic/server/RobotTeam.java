package majic.server;

import java.io.IOException;
import java.util.List;
import java.util.OptionalInt;
import majic.act.NoActs;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.environment.Settings;
import majic.log.SessionLog;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Team;
import majic.time.TimeSource;

/** A session with robot 1, a double that reaches every place at once. */
final class RobotTeam implements AutoCloseable {
    final Team team = new Team(TimeSource.system());
    final Session session;
    final FakeBot bot;

    RobotTeam() {
        BotFactory factory = new BotFactory(List.of(new FakeType()), Settings.inMemory());
        session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
        bot = (FakeBot) factory.create("fake://one");
        bot.connect();
        team.add(bot, OptionalInt.empty());
    }

    @Override
    public void close() throws IOException {
        team.close();
    }
}
