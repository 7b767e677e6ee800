package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.link.Links;
import majic.pioneer.arcos.Packet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Closing the robot while it is being connected. */
class ClosingTest {
    private final ScriptedPioneer robot = ScriptedPioneer.robot();
    private final AtomicInteger packets = new AtomicInteger();

    /** Counts received packets, in place of the robot. */
    private final class Counting implements SteppedPeer.Robot {
        @Override
        public void connected(SteppedPeer line) {
            robot.connected(line);
        }

        @Override
        public void received(SteppedPeer line, Packet packet) {
            packets.incrementAndGet();
            robot.received(line, packet);
        }

        @Override
        public void step(SteppedPeer line) {
            robot.step(line);
        }

        @Override
        public void left() {
            robot.left();
        }
    }

    @ParameterizedTest(name = "at packet {0}")
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9})
    void endsAConnectionCleanlyAtEveryStep(int packet) {
        robot.answersConfig = false;
        try (PioneerRig stage = new PioneerRig(robot, new Counting(), 3)) {
            Throwable thrown = stage.meanwhile(MajicPioneer::connect, () -> {
                stage.line.await(() -> packets.get() >= packet, 10);
                stage.bot.close();
            });
            stage.line.pass(2);

            assertThat(thrown).isInstanceOf(BotException.class);
            assertThat(stage.bot.connection()).isEqualTo(MajicBot.Connection.CLOSED);
            assertThat(robot.heard).noneMatch(order -> order.matches("(ENABLE 1|R?VEL [^0].*)"));
            assertThat(robot.heard.isEmpty() || robot.heard.contains("CLOSE 1")).isTrue();
            assertThat(Links.traffic()).noneMatch(traffic -> traffic.remote().equals(stage.line.where()));
        }
    }
}
