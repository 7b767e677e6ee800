package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import majic.bot.BotException;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Connecting, closing, and the values that the robot reports. */
class MajicHemissonTest {
    @AutoClose
    private final DrivenHemisson pair = new DrivenHemisson();

    private final ScriptedHemisson robot = pair.robot();
    private final MajicHemisson bot = pair.bot();

    @Test
    void connectingSendsAStopAndNothingThatMovesIt() {
        bot.connect();

        assertThat(robot.commands()).startsWith("", "B", "I", "E", "D,0,0");
        assertThat(robot.commands()).allMatch(command -> !command.startsWith("D") || command.equals("D,0,0"));
    }

    @Test
    void aTelnetPeerIsRefusedWithASentence() {
        robot.greetWith((byte) 0xFF, (byte) 0xFD, (byte) 0x03);

        assertThatThrownBy(bot::connect).isInstanceOf(BotException.class).hasMessageContaining("raw TCP");
        assertThat(robot.commands()).isEmpty();
    }

    @Test
    void aSilentPeerFailsTheConnectingWithAdvice() {
        robot.fallSilent(true);

        assertThatThrownBy(bot::connect).isInstanceOf(BotException.class).hasMessageContaining("wait 5 s");
        assertThat(robot.count("B")).isEqualTo(2);
    }

    @Test
    void aWrongRunningModeIsReported() {
        robot.answer('I', command -> "i,1,0,1,1");

        bot.connect();

        assertThat(pair.notices()).anyMatch(notice -> notice.contains("[1, 0, 1, 1]"));
    }

    @Test
    void aRobotMovedByItsRunningModeIsReportedAsMoving() {
        robot.answer('I', command -> "i,1,0,1,1");
        robot.answer('E', command -> "e,10,05");

        bot.connect();

        assertThat(bot.state().moving()).isTrue();
        assertThat(bot.state().speedMmPerSec()).isPositive();
    }

    @Test
    void aRobotOfAnOlderFirmwareIsReportedAsMovingIfItsRunningModeMayMoveIt() {
        robot.answer('I', command -> "i,1,0,1,1");
        robot.answer('E', command -> "Unknown Command ?!");

        bot.connect();
        pair.await(() -> bot.state().moving());

        assertThat(bot.state().speedMmPerSec()).isZero();
    }

    @Test
    void aRobotDrivenByATvRemoteControlIsReportedAsMoving() {
        bot.connect();
        robot.answer('E', command -> "e,-9,09");

        pair.await(() -> bot.state().moving());

        assertThat(bot.state().turnRateDegPerSec()).isPositive();
    }

    @Test
    void aRobotInAnUnknownModeIsSentNothingLong() {
        robot.answer('I', command -> "i,0,0,0,0");

        bot.connect();

        assertThat(robot.commands()).allMatch(command -> command.length() <= 1);
    }

    @Test
    void theFirstReadingsArePresentWhenItIsConnected() {
        bot.connect();

        WaitPolicy.without(() -> {
            assertThat(bot.get("prox")).hasToString("4, 4, 4, 4, 4, 4, 60, 80");
            assertThat(bot.get("groundLeft")).hasToString("60");
            assertThat(bot.get("light0")).hasToString("220");
            assertThat(bot.get("switches")).hasToString("1, 1, 1, 1");
            assertThat(bot.get("tvRemote")).hasToString("0");
        });
    }

    @Test
    void anOldGreetingFromABufferIsNotTakenForAStoppedRobot() {
        robot.greetWith(DrivenHemisson.GREETING.getBytes(StandardCharsets.ISO_8859_1));
        robot.answer('I', command -> "i,1,1,1,0");
        robot.answer('E', command -> "e,05,05");

        bot.connect();

        assertThat(pair.notices()).noneMatch(notice -> notice.contains("reset"));
        assertThat(bot.state().moving()).isTrue();
    }

    @Test
    void aGreetingDuringASessionIsReportedWithTheStateOfTheMotors() {
        bot.connect();
        pair.switchOffAndOn();
        pair.await(() -> !pair.notices().isEmpty());
        assertThat(pair.notices()).containsExactly("it was switched on or reset; its LEDs are off, its motors stand");

        robot.answer('E', command -> "e,05,05");
        pair.switchOffAndOn();
        pair.await(() -> pair.notices().size() > 1);
        assertThat(pair.notices().get(1)).endsWith("its motors run");
    }

    @Test
    void closingSendsAStop() {
        bot.connect();
        int before = robot.commands().size();

        bot.close();

        assertThat(robot.commands().subList(before, robot.commands().size())).contains("D,0,0");
    }

    @Test
    void aMissingSensorIsReportedWithTheReason() {
        assertThat(bot.get("battery")).hasToString("unknown (no command of the Hemisson tells it)");
        assertThat(bot.get("odometer").toString()).contains("no wheel encoders");
    }

    @Test
    void theErrorOfTheFirmwareInTheLeftGroundReadingIsCorrected() {
        bot.connect();
        pair.await(() -> bot.get("prox7").toString().equals("80"));

        assertThat(bot.get("groundLeft").number()).isEqualTo(60);
    }

    @Test
    void allLedsAreSentTogetherAndTheirStateIsStored() {
        bot.connect();

        bot.set("ledLeft", "on");
        bot.set("ledPgm", "on");

        assertThat(robot.commands()).contains("L,0,0,1,0", "L,0,1,1,0");
        assertThat(bot.get("ledLeft").isYes()).isTrue();
        assertThat(bot.get("light").isYes()).isFalse();
    }

    @Test
    void theAddressOfAnotherTypeIsRefused() {
        assertThatThrownBy(() -> new MajicHemisson("pioneer://10.0.0.5"))
                .isInstanceOf(BotException.class)
                .hasMessage("pioneer://10.0.0.5: not a Hemisson's address; it looks like hemisson:COM3 or"
                        + " hemisson://host:port");
        assertThatThrownBy(() -> new MajicHemisson("hemisson+aria:COM3"))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("there is no library aria for it");
    }
}
