package majic.team;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.bot.Value;
import majic.drivertest.TestClock;

/** A team of robots that exist only here, on a stepped clock that the thread of the test has joined. */
final class TeamFixture implements AutoCloseable {
    final TestClock clock = new TestClock();
    final Team team = new Team(clock.time());

    /** The answers since {@link #listen()}. */
    final List<String> said = Collections.synchronizedList(new ArrayList<>());

    @Override
    public void close() {
        team.close();
        clock.close();
    }

    FakeBot join() {
        FakeBot bot = FakeBot.on(clock.time());
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }

    void listen() {
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                said.add(answer.text());
            }
        });
    }

    static QueuedCommand move(double mm) {
        String text = "move " + Value.plain(mm);
        return new QueuedCommand(text, true, robot -> List.of(text + ": done (" + robot.move(mm) + ")"));
    }

    boolean awaitIdle(int robot) throws InterruptedException {
        return team.changes().await(() -> team.member(robot).isIdle(), 100);
    }
}
