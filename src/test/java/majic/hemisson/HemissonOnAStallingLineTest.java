package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests a serial server that holds data for a while and then delivers all of it at once, with a robot with the real
 * receiver: a stop that arrives together with a query would overrun it, and the robot would not stop.
 */
class HemissonOnAStallingLineTest {
    @AutoClose
    private LabRig rig;

    private MajicBot bot;

    @BeforeEach
    void connect() {
        rig = LabRig.exactWithHemisson("kteam+ultrasonic+overrun+paced");
        bot = rig.add("hemisson");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.02, 1.04, 1.2, 1.24, 1.64})
    void aDriveGoesOnBehindAShortStall(double begin) throws InterruptedException {
        stall(begin, 0.2);

        bot.drive(100, 0, 3, Guard.NEVER);

        assertItIsStoppedAndAnswers();
    }

    @ParameterizedTest
    @CsvSource({
        "1, 0.5",
        "1.02, 0.5",
        "1.04, 0.5",
        "1.2, 0.5",
        "1.24, 0.5",
        "1.64, 0.5",
        "1, 1.5",
        "1.02, 1.5",
        "1.04, 1.5",
        "1.2, 1.5",
        "1.24, 1.5",
        "1.64, 1.5"
    })
    void whateverAStallHoldsTheRobotReceivesTheStopBehindIt(double begin, double seconds) throws InterruptedException {
        stall(begin, seconds);

        driveInto(begin + 2);
        rig.lab().time().sleep(seconds);

        assertItIsStoppedAndAnswers();
    }

    @ParameterizedTest
    @CsvSource({"1, 2.7", "1.2, 2.7", "1.64, 2.7", "1.02, 3.7", "1.64, 3.7"})
    void itIsStoppedAfterALongStallThoughItMayBeDeaf(double begin, double seconds) throws InterruptedException {
        stall(begin, seconds);

        driveInto(begin + 2);
        rig.lab().time().sleep(seconds);

        Pose stands = rig.truePose("hemisson");
        rig.lab().time().sleep(5);
        assertThat(rig.truePose("hemisson")).isEqualTo(stands);
    }

    @ParameterizedTest
    @CsvSource({"1, 0.2", "1, 0.5", "1.02, 0.5", "1.2, 0.5", "1, 1.5", "1.04, 1.5", "1.24, 1.5"})
    void aStopThatIsPressedInAStallIsObeyedAsSoonAsItIsOver(double begin, double seconds) throws InterruptedException {
        stall(begin, seconds);
        rig.after(begin + 0.15, bot::stop);

        assertThatThrownBy(() -> bot.drive(100, 0, 20, Guard.NEVER)).isInstanceOf(MotionStopped.class);
        rig.lab().time().sleep(seconds);

        assertItIsStoppedAndAnswers();
    }

    @Test
    void aMotionThatBeginsInAStallIsStoppedInIt() throws InterruptedException {
        stall(0.5, 1.5);
        rig.lab().time().sleep(0.6);
        rig.after(0.2, bot::stop);

        assertThatThrownBy(() -> bot.drive(100, 0, 20, Guard.NEVER)).isInstanceOf(MotionStopped.class);
        rig.lab().time().sleep(1.5);

        assertItIsStoppedAndAnswers();
    }

    private void driveInto(double longestSeconds) {
        try {
            bot.drive(100, 0, longestSeconds, Guard.NEVER);
        } catch (BotException e) {
            assertThat(e).hasMessageContaining("missed an answer");
        }
    }

    private void assertItIsStoppedAndAnswers() throws InterruptedException {
        rig.lab().time().sleep(0.2);
        Pose stands = rig.truePose("hemisson");
        assertThat(bot.isConnected()).isTrue();
        bot.turn(20);
        Pose turned = rig.truePose("hemisson");
        assertThat(turned.xMm()).isEqualTo(stands.xMm());
        assertThat(turned.headingDeg()).isNotEqualTo(stands.headingDeg());
    }

    private void stall(double begin, double seconds) {
        rig.after(begin, () -> rig.lab().simulators().faults("hemisson").outage(seconds));
    }
}
