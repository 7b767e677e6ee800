package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.Random;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.link.Links;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Packet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Peers that send too little, too much or garbage, and robots that fail and restart. */
class RobustnessTest {
    private static final double CONNECT_LIMIT_S = 11;

    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    /** Another peer in place of the robot. */
    private abstract class Impostor implements SteppedPeer.Robot {
        @Override
        public void received(SteppedPeer line, Packet packet) {}
    }

    private void refuses(SteppedPeer.Robot impostor) {
        try (PioneerRig stage = new PioneerRig(robot, impostor, 0)) {
            double seconds = stage.secondsOf(() -> assertThatThrownBy(stage.bot::connect)
                    .isInstanceOf(BotException.class)
                    .hasMessageMatching("(?s).{20,}"));
            assertThat(seconds).isLessThan(CONNECT_LIMIT_S);
            assertThat(stage.bot.connection()).isEqualTo(MajicBot.Connection.LOST);
        }
    }

    @Test
    void aPeerThatSendsGarbageIsGivenUp() {
        Random random = new Random(4);
        refuses(new Impostor() {
            @Override
            public void step(SteppedPeer line) {
                byte[] rubbish = new byte[20];
                random.nextBytes(rubbish);
                line.send(rubbish);
            }
        });
    }

    @Test
    void aPeerThatSendsAByteASecondIsGivenUp() {
        byte[] answer = Bytes.wire(0, new byte[0]);
        refuses(new Impostor() {
            @Override
            public void step(SteppedPeer line) {
                if (line.millis() % 1000 == 0) {
                    line.send(new byte[] {answer[(int) (line.millis() / 1000 % answer.length)]});
                }
            }
        });
    }

    @Test
    void aPeerThatEchoesEverythingIsGivenUp() {
        refuses(new Impostor() {
            @Override
            public void received(SteppedPeer line, Packet packet) {
                line.send(Bytes.wire(packet.type(), packet.data()));
            }
        });
    }

    @ParameterizedTest(name = "silent from step {0} on")
    @ValueSource(ints = {0, 1, 2, 3})
    void aPeerThatStallsInTheHandshakeIsGivenUp(int steps) {
        refuses(new Impostor() {
            private int answered;

            @Override
            public void received(SteppedPeer line, Packet packet) {
                if (answered++ < steps) {
                    line.send(packet.type() == 2 ? Bytes.of(Bytes.NAMES) : Bytes.wire(packet.type(), new byte[0]));
                }
            }
        });
    }

    @ParameterizedTest(name = "closes after {0} bytes")
    @ValueSource(ints = {1, 3, 6, 7, 12, 13, 20, 38})
    void aCloseAtAnyByteIsReportedAsAClose(int bytes) {
        refuses(new Impostor() {
            private int left = bytes;

            @Override
            public void received(SteppedPeer line, Packet packet) {
                byte[] whole = packet.type() == 2 ? Bytes.of(Bytes.NAMES) : Bytes.wire(packet.type(), new byte[0]);
                line.send(Arrays.copyOf(whole, Math.min(left, whole.length)));
                left -= whole.length;
            }

            @Override
            public void step(SteppedPeer line) {
                if (left <= 0) {
                    line.hangUp();
                }
            }
        });
    }

    @Test
    void aSessionSurvivesAnySingleDamagedByte() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            byte[] sip = robot.sip();
            for (int at = 0; at < sip.length; at++) {
                byte[] damaged = sip.clone();
                damaged[at] ^= 0x55;
                stage.line.send(damaged);
                stage.line.send(Arrays.copyOf(sip, at));
                stage.line.pass(0.15);
            }

            assertThat(stage.bot.isConnected()).isTrue();
            assertThat(stage.bot.state().pose().xMm()).isZero();
            assertThat(PioneerRig.amount(stage.bot.move(100))).isBetween(90.0, 110.0);
        }
    }

    @Test
    void aRobotThatDiesAndComesBackIsConnectedAgainTwentyTimesWithoutLeavingAnythingBehind() {
        try (PioneerRig stage = PioneerRig.connected(robot)) {
            long threads = threads();
            for (int time = 0; time < 20; time++) {
                stage.line.hangUp();
                assertThat(stage.line.await(() -> !stage.bot.isConnected(), 5)).isTrue();
                stage.bot.connect();
                assertThat(PioneerRig.amount(stage.bot.move(20))).isBetween(10.0, 30.0);
            }

            assertThat(robot.connections).isEqualTo(21);
            assertThat(threads()).isEqualTo(threads);
            assertThat(Links.traffic().stream()
                            .filter(traffic -> traffic.remote().equals(stage.line.where())))
                    .hasSize(1);
        }
    }

    private static long threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("pioneer"))
                .count();
    }
}
