package majic.pioneer.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.MotionReport;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.pioneer.MajicPioneer;
import majic.pioneer.PioneerRig;
import majic.pioneer.ScriptedPioneer;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** What is sent when parameters are set, and what is read, of a robot with little equipment. */
class PioneerParametersTest {
    private final ScriptedPioneer robot = ScriptedPioneer.robot();

    @AutoClose
    private final PioneerRig stage = PioneerRig.connected(robot);

    private final MajicPioneer bot = stage.bot;

    @Test
    void aPoseThatIsSetIsReportedAndSendsNothing() {
        int before = orders().size();

        bot.set("pose", numbers(100, 200, 90));

        assertThat(bot.get("pose")).hasToString("100 mm, 200 mm, 90 deg");
        assertThat(bot.state().pose().yMm()).isEqualTo(200);
        assertThat(orders()).hasSize(before);
    }

    @Test
    void whatSettingThePoseLeavesOutStaysAsItIs() {
        bot.set("pose", numbers(100, 200, 90));

        bot.set("x", 5);
        assertThat(bot.get("pose")).hasToString("5 mm, 200 mm, 90 deg");
        bot.set("pose", numbers(-1));
        assertThat(bot.get("pose")).hasToString("-1 mm, 200 mm, 90 deg");
        bot.set("heading", -270);
        assertThat(bot.get("heading")).hasToString("90 deg");
    }

    @Test
    void rampsAreNotChangedUnderAMotionThatBrakesByThem() {
        List<String> refused = new ArrayList<>();
        stage.whenBeyond(100, () -> {
            try {
                bot.set("deceleration", 20);
            } catch (BotException e) {
                refused.add(String.valueOf(e.getMessage()));
            }
        });

        bot.move(300);

        assertThat(refused).singleElement().asString().contains("is moving");
        assertThat(bot.get("deceleration")).hasToString("500 mm/s²");
    }

    @Test
    void aStopTakesTheRobotFromItsOwnJoystick() {
        bot.set("joystickDrive", "on");

        bot.stop();
        stage.line.pass(0.01);

        assertThat(orders()).filteredOn(order -> order.startsWith("JOYDRIVE")).endsWith("JOYDRIVE 1", "JOYDRIVE 0");
        assertThat(bot.get("joystickDrive")).hasToString("off");
    }

    @Test
    void aPoseSetInTheMiddleOfAMotionDoesNotDisturbIt() {
        stage.whenBeyond(
                200,
                () -> stage.line
                        .time()
                        .thread("setting", () -> bot.set("pose", numbers(5000, 5000, 45)))
                        .start());

        MotionReport report = bot.move(600);

        assertThat(PioneerRig.amount(report)).isCloseTo(600, within(10.0));
        assertThat(robot.robot.x()).isCloseTo(600, within(12.0));
    }

    @Test
    void rampsAreSentToTheRobotAndFollowed() {
        double before = stage.secondsOf(() -> bot.move(1000));

        bot.set("acceleration", 100);
        bot.set("deceleration", 100);

        assertThat(orders()).contains("SETA 100", "SETA -100");
        assertThat(bot.get("deceleration")).hasToString("100 mm/s²");
        assertThat(stage.secondsOf(
                        () -> assertThat(PioneerRig.amount(bot.move(1000))).isCloseTo(1000, within(10.0))))
                .isGreaterThan(before + 1);
    }

    @Test
    void theTopSpeedBoundsCruiseAndDrive() {
        bot.set("topSpeed", 150);

        assertThat(orders()).contains("SETV 150");
        assertThat(bot.get("cruise")).hasToString("150 mm/s");
        assertThatThrownBy(() -> bot.drive(200, 0)).hasMessage("drive 200: outside -150 … 150 mm/s");
        assertThatThrownBy(() -> bot.set("topSpeed", 2300)).hasMessage("topSpeed 2300: outside 1 … 2200 mm/s");
    }

    @Test
    void rampsThatWereSetAreSentAgainInTheNextSession() {
        bot.set("turnAcceleration", 60);
        robot.heard.clear();
        stage.line.hangUp();
        stage.line.await(() -> !bot.isConnected(), 5);

        bot.connect();

        assertThat(orders()).contains("SETRA 60");
    }

    @Test
    void whatConfigRulesOutIsNotDescribed() {
        assertThatThrownBy(() -> bot.get("bumpFront1"))
                .isInstanceOf(ParameterException.class)
                .hasMessageStartingWith("bumpFront1: the Pioneer has no such parameter");
        assertThatThrownBy(() -> bot.run("gripper", List.of(Value.text("open"))))
                .hasMessageStartingWith("gripper: the Pioneer has no such command");
        assertThat(names()).doesNotContain("gripper", "gyro", "bumpers", "sonar16");
    }

    @Test
    void whatOnlyReadingsCanShowIsUnknownWithItsReason() {
        Stream.of("digitalIn", "analog", "charging", "compass", "temperature", "faults", "encoderLeft", "joystickX")
                .forEach(name -> assertThat(bot.get(name)).hasToString("unknown (this robot does not tell)"));
        assertThat(bot.get("mute")).hasToString("unknown (the robot does not report it, and it was not set)");
    }

    @Test
    void digitalOutputsAreSetByByteOrByBit() {
        bot.set("digitalOut", 0x15);
        bot.set("digitalOut3", "on");
        bot.set("digitalOut3", "off");

        assertThat(orders())
                .containsSubsequence("DIGOUT " + (0xFF00 | 0x15), "DIGOUT " + (0x0800 | 0x08), "DIGOUT " + 0x0800);
    }

    @Test
    void fractionsOfWholeNumbersAreRefusedBeforeAnythingIsSent() {
        List<Value> fraction = List.of(Value.of(2.5, Unit.NONE));
        for (String parameter : List.of("digitalOut", "analogPort")) {
            assertThatThrownBy(() -> bot.checkSet(parameter, fraction))
                    .hasMessage(parameter + " 2.5: not a whole number");
        }
    }

    @Test
    void aSwitchThatIsNotSeenToSwitchIsAFailure() {
        assertThatThrownBy(() -> bot.set("sonarPower", "off"))
                .isInstanceOf(BotException.class)
                .hasMessage("the sonars did not switch off within 1 s");
        assertThat(orders()).contains("SONAR 0");
    }

    @Test
    void sonarArraysAreSwitchedOneByOne() {
        bot.set("sonarPower2", "on");

        assertThat(orders()).contains("SONAR 5");
    }

    @Test
    void tonesAreSentAndTooManyRefused() {
        Value answer = Value.text(bot.run("tones", numbers(200, 72, 100, 0)));

        assertThat(answer).hasToString("0.3 s of tones");
        assertThat(orders()).anyMatch(order -> order.startsWith("SAY "));
        List<Value> long21 = Stream.generate(() -> numbers(20, 60))
                .limit(21)
                .flatMap(List::stream)
                .toList();
        assertThatThrownBy(() -> bot.run("tones", long21)).hasMessage("tones: 21 are too many, the robot takes 20");
        assertThatThrownBy(() -> bot.run("tones", numbers(10, 60))).hasMessage("duration 10: outside 20 … 5100 ms");
    }

    @Test
    void aSettingThatIsNotReportedIsKeptForItsSession() {
        bot.set("mute", "on");

        assertThat(bot.get("mute")).hasToString("on");
        assertThat(orders()).contains("SOUNDTOG 0");
    }

    @Test
    void theLinkIsJudged() {
        stage.line.pass(3);

        assertThat(bot.get("packetRate").number()).isCloseTo(10, within(0.5));
        assertThat(bot.get("longestSilence").number()).isCloseTo(100, within(10.0));
        assertThat(bot.get("damagedPackets")).isEqualTo(Value.of(0, Unit.NONE));
    }

    /** What the robot has received, after the time that takes. */
    private List<String> orders() {
        stage.line.pass(0.1);
        return robot.orders();
    }

    private List<String> names() {
        return bot.parameters().stream().map(Parameter::name).toList();
    }

    private static List<Value> numbers(double... amounts) {
        return Arrays.stream(amounts)
                .mapToObj(amount -> Value.of(amount, Unit.NONE))
                .toList();
    }
}
