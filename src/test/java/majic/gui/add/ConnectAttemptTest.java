package majic.gui.add;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import majic.act.NoActs;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot.Connection;
import majic.environment.Settings;
import majic.gui.ToyBot;
import majic.gui.ToyType;
import majic.gui.WindowWait;
import majic.log.SessionLog;
import majic.script.Session;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class ConnectAttemptTest {
    private final ToyType type = new ToyType(BotType.Reach.TCP);

    @AutoClose
    private final Team team = new Team(TimeSource.system(), 1);

    private final Session session = new Session(
            team, new BotFactory(List.of(type), Settings.inMemory()), SessionLog.none(), NoActs.here(), () -> {});
    private final BlockingQueue<String> heard = new ArrayBlockingQueue<>(10);

    @Test
    void aConnectedRobotJoins() throws InterruptedException {
        attempt("toy://here").start();
        assertThat(heard.take()).isEqualTo("joined as 1");
    }

    @Test
    void aLostRobotIsConnectedAgainUnderItsNumber() throws InterruptedException {
        attempt("toy://here").start();
        heard.take();
        ToyBot bot = type.made.get(0);
        bot.loseLink();
        attempt("toy://here").start();
        assertThat(heard.take()).isEqualTo("joined as 1");
        assertThat(type.made).containsExactly(bot);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aFullTeamIsNotConnectedToAnybody() throws InterruptedException {
        attempt("toy://here").start();
        heard.take();
        attempt("toy://there").start();
        assertThat(heard.take()).startsWith("failed: the team is full");
        assertThat(type.made).hasSize(1);
    }

    @Test
    void anUnknownTypeFails() throws InterruptedException {
        attempt("doll://here").start();
        assertThat(heard.take()).startsWith("failed: doll: no such type of robot");
    }

    @Test
    void anErrorOfADriverEndsTheAttemptAndClosesTheRobot() throws InterruptedException {
        attempt("toy://defective").start();
        assertThat(heard.take()).startsWith("failed: ");
        assertThat(type.made.get(0).connection()).isEqualTo(Connection.CLOSED);
    }

    @Test
    void aCancelledAttemptClosesTheRobotWithoutAReport() throws InterruptedException {
        ConnectAttempt attempt = attempt("toy://silent");
        attempt.start();
        WindowWait.await("the robot to be made", () -> !type.made.isEmpty());
        ToyBot bot = type.made.get(0);
        WindowWait.await("the connecting", () -> bot.connection() == Connection.CONNECTING);
        attempt.cancel();
        bot.closed.await();
        assertThat(heard.poll(200, TimeUnit.MILLISECONDS)).isNull();
        assertThat(bot.connection()).isEqualTo(Connection.CLOSED);
    }

    private ConnectAttempt attempt(String address) {
        return new ConnectAttempt(session, address, new ConnectAttempt.Outcome() {
            @Override
            public void joined(Member member) {
                heard.add("joined as " + member.number());
            }

            @Override
            public void failed(BotException reason) {
                heard.add("failed: " + reason.getMessage());
            }
        });
    }
}
