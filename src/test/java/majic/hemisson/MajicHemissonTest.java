package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import majic.bot.BotEnvironment;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class MajicHemissonTest {
    private final List<String> notices = new CopyOnWriteArrayList<>();
    private ScriptedHemisson robot;
    private MajicHemisson bot;

    @BeforeEach
    void makeBoth() throws Exception {
        robot = new ScriptedHemisson();
        bot = new MajicHemisson(robot.address(), BotEnvironment.plain());
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot who, String message) {
                notices.add(message);
            }
        });
    }

    @AfterEach
    void closeBoth() throws Exception {
        bot.close();
        robot.close();
    }

    @Test
    void connectingTellsItToStandAndNothingElseThatMoves() {
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
    void aSilentPeerIsGivenUpWithWhatToTry() {
        robot.fallSilent(true);

        assertThatThrownBy(bot::connect).isInstanceOf(BotException.class).hasMessageContaining("wait 5 s");
        assertThat(robot.count("B")).isEqualTo(2);
    }

    @Test
    void aWrongRunningModeIsReported() {
        robot.answer('I', command -> "i,1,0,1,1");

        bot.connect();

        assertThat(notices).anyMatch(notice -> notice.contains("[1, 0, 1, 1]"));
    }

    @Test
    void aRobotInAnUnknownModeIsSentNothingLong() {
        robot.answer('I', command -> "i,0,0,0,0");

        bot.connect();

        assertThat(robot.commands()).allMatch(command -> command.length() <= 1);
    }

    @Test
    void movesAsLongAsTheTableSays() {
        bot.connect();

        MotionReport report = bot.move(42);

        assertThat(report.toString()).startsWith("about 4");
        assertThat(millisBetween("D,3,3", "D,0,0")).isCloseTo(1000, within(150L));
        assertThat(bot.state().pose().xMm()).isCloseTo(42, within(6.0));
        assertThat(bot.state().moving()).isFalse();
    }

    @Test
    void turnsLeftForAPositiveAngle() {
        bot.connect();

        bot.turn(40);

        assertThat(millisBetween("D,-3,3", "D,0,0")).isCloseTo(748, within(150L));
        assertThat(bot.get("heading").number()).isCloseTo(40, within(8.0));
    }

    @Test
    void isAskedWhatItSeesAllTheWhileItMoves() {
        bot.connect();
        bot.move(42);

        long start = heardAt("D,3,3");
        List<Long> looks = robot.heard().stream()
                .filter(heard -> heard.nanos() > start && heard.nanos() < start + 900_000_000L)
                .map(ScriptedHemisson.Heard::nanos)
                .toList();
        assertThat(looks).hasSizeGreaterThan(8);
    }

    @Test
    void aGuardThatHoldsAlreadyLetsItStand() {
        robot.answer('N', command -> "n,060,004,004,004,004,004,060,080");
        bot.connect();

        bot.move(100, () -> bot.get("distanceFront").number() < 40);

        assertThat(robot.count("D,3,3")).isZero();
    }

    @Test
    void aGuardEndsAMoveAtTheReadingThatShowsIt() {
        bot.connect();
        robot.answer('N', command -> robot.count("D,3,3") == 0 ? far() : near());

        bot.move(1000, () -> bot.get("distanceFront").number() < 40);

        assertThat(millisBetween("D,3,3", "D,0,0")).isLessThan(500);
    }

    @Test
    void stopEndsAMotion() throws Exception {
        bot.connect();
        Thread stopper = new Thread(() -> {
            await(() -> robot.count("D,3,3") == 1);
            bot.stop();
        });
        stopper.start();

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(MotionStopped.class);
        stopper.join();
        assertThat(robot.commands()).endsWith("D,0,0", "E");
    }

    @Test
    void fromTheFirstMissedAnswerWhileItMovesItIsToldToStandAgainAndAgain() {
        bot.connect();
        fallSilentWhenMoving();

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(BotException.class);
        await(() -> robot.count("D,0,0") >= 4);

        assertThat(afterMotion()).filteredOn(command -> command.startsWith("D")).containsOnly("D,0,0");
        assertThat(notices).anyMatch(notice -> notice.contains("lift it"));
    }

    @Test
    void afterAMissedAnswerTheStopIsVerifiedAndTheMotionFails() {
        bot.connect();
        robot.answer('N', command -> robot.count("D,3,3") == 1 && robot.count("D,0,0") == 1 ? "noise" : far());

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("missed");

        assertThat(afterMotion()).containsSubsequence("D,0,0", "E");
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void lastingSilenceIsExplained() {
        bot.connect();
        robot.fallSilent(true);

        await(() -> !bot.isConnected());

        assertThatThrownBy(() -> bot.move(10)).isInstanceOf(LinkLost.class).hasMessageContaining("wait 5 s");
    }

    @Test
    void aLinkCutWhileItMovesSaysWhatAPersonCanDo() {
        bot.connect();
        Thread cutter = new Thread(() -> {
            await(() -> robot.count("D,3,3") == 1);
            hangUp();
        });
        cutter.start();

        assertThatThrownBy(() -> bot.move(1000)).isInstanceOf(LinkLost.class).hasMessageContaining("lift it");
    }

    @Test
    void connectsAnewAfterALostLink() throws Exception {
        bot.connect();
        robot.hangUp();
        await(() -> !bot.isConnected());

        bot.connect();

        bot.move(5);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void closingTellsItToStand() {
        bot.connect();
        int before = robot.commands().size();

        bot.close();

        assertThat(robot.commands().subList(before, robot.commands().size())).contains("D,0,0");
    }

    @Test
    void aResetInMidMotionEndsIt() {
        bot.connect();
        Thread resetter = new Thread(() -> {
            await(() -> robot.count("D,3,3") == 1);
            greet();
        });
        resetter.start();

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("reset");
    }

    @Test
    void wheelsThatSomethingElseSetEndTheMotion() {
        bot.connect();
        robot.answer('E', command -> "e,00,00");

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(MotionFailed.class)
                .hasMessageContaining("remote control");
    }

    @Test
    void aDriveThatIsNotRenewedIsEnded() {
        bot.connect();

        bot.drive(42, 0);
        await(() -> robot.count("D,3,3") == 1 && afterMotion().contains("D,0,0"));

        assertThat(millisBetween("D,3,3", "D,0,0")).isBetween(500L, 900L);
    }

    @Test
    void whatItLacksIsAnsweredWithTheReason() {
        assertThat(bot.get("battery")).hasToString("unknown (no command of the Hemisson tells it)");
        assertThat(bot.get("odometer").toString()).contains("no wheel encoders");
    }

    @Test
    void theFirmwaresSlipInTheLeftGroundReadingIsCorrected() {
        bot.connect();
        await(() -> bot.get("prox7").toString().equals("80"));

        assertThat(bot.get("groundLeft").number()).isEqualTo(60);
    }

    @Test
    void lampsAreSetTogetherAndRemembered() {
        bot.connect();

        bot.set("ledLeft", "on");
        bot.set("ledPgm", "on");

        assertThat(robot.commands()).contains("L,0,0,1,0", "L,0,1,1,0");
        assertThat(bot.get("ledLeft").isYes()).isTrue();
        assertThat(bot.get("light").isYes()).isFalse();
    }

    private static String far() {
        return "n,004,004,004,004,004,004,060,080";
    }

    private static String near() {
        return "n,060,004,004,004,004,004,060,080";
    }

    private void fallSilentWhenMoving() {
        robot.answer('D', command -> {
            robot.fallSilent(!command.equals("D,0,0"));
            return "d";
        });
    }

    private void hangUp() {
        try {
            robot.hangUp();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void greet() {
        try {
            robot.say("HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30");
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private long heardAt(String command) {
        return robot.heard().stream()
                .filter(heard -> heard.command().equals(command))
                .findFirst()
                .orElseThrow()
                .nanos();
    }

    private List<String> afterMotion() {
        List<String> all = robot.commands();
        return all.subList(all.indexOf("D,3,3") + 1, all.size());
    }

    private long millisBetween(String first, String second) {
        long from = heardAt(first);
        return robot.heard().stream()
                .filter(heard -> heard.command().equals(second) && heard.nanos() > from)
                .mapToLong(heard -> (heard.nanos() - from) / 1_000_000)
                .findFirst()
                .orElseThrow();
    }

    private static void await(BooleanSupplier condition) {
        try {
            while (!condition.getAsBoolean()) {
                BotEnvironment.plain().time().sleep(0.005);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void aStopInWhichTheConnectionIsLostIsNotConfirmed() {
        bot.connect();
        robot.answer('D', command -> robot.hangUpInsteadOfAnswering());

        assertThatThrownBy(bot::stop).isInstanceOf(BotException.class).hasMessageContaining("lost");
    }
}
