package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Value;
import majic.pioneer.arcos.Bytes;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Guard conditions and listeners that read reports beside the SIPs, without blocking other threads. */
class GuardTest {
    private static final int ENCODERS = 0x90;
    private static final byte[] AT_ZERO = new byte[8];
    private static final byte[] AT_HUNDRED = {100, 0, 0, 0, 0, 0, 0, 0};

    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    @AutoClose
    private final PioneerRig stage = PioneerRig.connected(robot);

    private void encoders(byte[] ticks) {
        stage.line.send(Bytes.wire(ENCODERS, ticks));
    }

    @Test
    void aGuardIsTestedWhenItsPacketComesAndNotWithTheNextSip() {
        long[] sentMs = {0};
        encoders(AT_ZERO);
        stage.whenBeyond(100, () -> {
            sentMs[0] = stage.line.millis();
            encoders(AT_HUNDRED);
        });

        stage.bot.move(1000, () -> stage.bot.get("encoderLeft").number() > 50);

        assertThat(robot.heardAt.get(robot.heard.indexOf("STOP 0")) - sentMs[0]).isLessThan(20);
    }

    @Test
    void aGuardNeverWaitsForAPacketThatDoesNotComeAnyMore() {
        List<Double> waits = new ArrayList<>();
        encoders(AT_ZERO);
        Guard guard = () -> {
            List<Value> read = new ArrayList<>();
            waits.add(stage.secondsOf(() -> read.add(stage.bot.get("encoderLeft"))));
            return read.get(0).number() > 50;
        };

        assertThatThrownBy(() -> stage.bot.move(5000, guard))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("no reading of late");
        assertThat(waits.subList(1, waits.size())).isNotEmpty().allMatch(seconds -> seconds < 0.001);
    }

    @Test
    void aGuardMayWaitForItsFirstReadingBeforeTheRobotMoves() {
        stage.line
                .time()
                .thread("late encoders", () -> {
                    stage.line.pass(0.3);
                    encoders(AT_HUNDRED);
                })
                .start();

        assertThat(PioneerRig.amount(
                        stage.bot.move(1000, () -> stage.bot.get("encoderLeft").number() > 50)))
                .isZero();
    }

    @Test
    void aRobotThatDoesNotComeToRestAfterItsGuardHasFailed() {
        Guard guard = () -> {
            boolean reached = stage.bot.state().pose().xMm() > 100;
            if (reached) {
                robot.governor = speed -> 250;
            }
            return reached;
        };

        assertThatThrownBy(() -> stage.bot.move(1000, guard))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("it does not come to rest after ");
        robot.governor = speed -> speed;
    }

    @Test
    void readingInAListenerDoesNotBlock() {
        List<Value> read = new ArrayList<>();
        stage.bot.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot bot, BotState state) {
                read.add(bot.get("encoderLeft"));
            }
        });

        stage.line.pass(1.05);

        assertThat(read).hasSizeBetween(9, 12).allMatch(Value.Unknown.class::isInstance);
    }

    @Test
    void aListenerMayStopTheRobot() {
        stage.whenBeyond(50, stage.bot::stop);

        assertThatThrownBy(() -> stage.bot.move(1000)).hasMessage("stopped");
        stage.line.pass(2);

        assertThat(robot.robot.isStationary()).isTrue();
        assertThat(stage.bot.isConnected()).isTrue();
    }
}
