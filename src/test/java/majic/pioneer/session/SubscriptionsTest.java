package majic.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import majic.bot.LinkLost;
import majic.drivertest.TestClock;
import majic.pioneer.arcos.Bytes;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.Packet;
import majic.pioneer.arcos.ReportKind;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class SubscriptionsTest {
    private static final String BATTERIES_STREAM = "62 2";
    private static final String PORTS_STREAM = "40 2";
    private static final String ENCODER_STREAM = "19 2";
    private static final String ENCODER_ONCE = "19 1";
    private static final boolean FAST = true;
    private static final boolean SLOW = false;
    private static final Encoders TICKS = new Encoders(1, 2);

    @AutoClose
    private final TestClock clock = new TestClock();

    private final List<Packet> sent = new ArrayList<>();

    @Test
    void aFastLineBringsWhatTheRobotHasFromTheStart() {
        on(FAST).begin(config(0, 0));

        assertThat(requests()).containsExactly(BATTERIES_STREAM, PORTS_STREAM);
    }

    @Test
    void gripperAndGyroAreRequestedIfConfigReportsThem() {
        on(FAST).begin(config(1, 1));

        assertThat(requests()).containsExactly(BATTERIES_STREAM, PORTS_STREAM, "37 2", "58 1");
    }

    @Test
    void aGyroThatTheControllerReadsItselfIsLeftAlone() {
        on(FAST).begin(config(0, 2));

        assertThat(requests()).doesNotContain("58 1");
    }

    @Test
    void aSlowLineIsLeftToTheSips() {
        on(SLOW).begin(config(1, 1));

        assertThat(requests()).isEmpty();
    }

    @Test
    void aFeedThatIsReadIsStreamed() throws InterruptedException {
        Subscriptions subscriptions = on(FAST);

        read(subscriptions, 10, true);

        assertThat(requests()).containsExactly(ENCODER_STREAM);
    }

    @Test
    void onASlowLineOneReportASecondIsRequestedWhileAFeedIsRead() throws InterruptedException {
        Subscriptions subscriptions = on(SLOW);

        read(subscriptions, 4, true);

        assertThat(requests()).hasSize(4).containsOnly(ENCODER_ONCE);
        pass(subscriptions, 30);
        assertThat(requests()).hasSizeLessThan(11);
    }

    @Test
    void aLostRequestIsRepeated() throws InterruptedException {
        Subscriptions subscriptions = on(FAST);

        read(subscriptions, 3, false);
        subscriptions.received(TICKS);
        read(subscriptions, 2, true);

        assertThat(requests()).hasSize(3).containsOnly(ENCODER_STREAM);
    }

    @Test
    void aStreamThatEndsIsRequestedAgain() throws InterruptedException {
        Subscriptions subscriptions = on(FAST);

        read(subscriptions, 3, true);
        read(subscriptions, 3, false);

        assertThat(requests()).hasSize(2);
    }

    @Test
    void requestsEndIfTheRobotNeverAnswers() throws InterruptedException {
        Subscriptions subscriptions = on(FAST);

        read(subscriptions, 60, false);

        assertThat(requests()).hasSize(5);
        assertThat(subscriptions.isMissing(ReportKind.ENCODERS)).isTrue();
        assertThat(subscriptions.isMissing(ReportKind.JOYSTICK)).isFalse();
    }

    private List<String> requests() {
        return sent.stream()
                .map(packet -> packet.type() + " " + packet.data()[1])
                .toList();
    }

    private Subscriptions on(boolean fast) {
        return new Subscriptions(new RecordingLine(sent, fast), clock.time());
    }

    /** A line that only records what is sent. */
    private record RecordingLine(List<Packet> sent, boolean isFast) implements RobotLine {
        @Override
        public void send(Packet... commands) {
            sent.addAll(List.of(commands));
        }

        @Override
        public long sentNanos() {
            return 0;
        }

        @Override
        public @Nullable LinkLost end() {
            return null;
        }

        @Override
        public void abort(LinkLost cause) {}
    }

    /** Reads the encoders for a while; the robot answers or does not. */
    private void read(Subscriptions subscriptions, double seconds, boolean answers) throws InterruptedException {
        for (double passed = 0; passed < seconds; passed += Subscriptions.PERIOD_S) {
            subscriptions.read(ReportKind.ENCODERS);
            pass(subscriptions, Subscriptions.PERIOD_S);
            if (answers) {
                subscriptions.received(TICKS);
            }
        }
    }

    private void pass(Subscriptions subscriptions, double seconds) throws InterruptedException {
        for (double passed = 0; passed < seconds; passed += Subscriptions.PERIOD_S) {
            subscriptions.requestDue();
            clock.time().sleep(Subscriptions.PERIOD_S);
        }
    }

    /** A CONFIG packet with these two fields, placed as in the sheet. */
    private static Config config(int gripper, int gyro) {
        byte[] data = Bytes.packet(Bytes.CONFIG).data();
        data[39] = (byte) gripper;
        data[88] = (byte) gyro;
        return Config.decode(new Packet(Config.TYPE, data, 0, data.length));
    }
}
