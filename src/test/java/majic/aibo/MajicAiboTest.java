package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class MajicAiboTest {
    private static final int SENSORS = 1;

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.lying();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;

    @Test
    void connectingSendsNothingThatMovesOrPowersTheDog() {
        aibo.connect();

        assertThat(aibo.get("distanceFront")).isEqualTo(Value.CLEAR);
        assertThat(dog.received())
                .noneMatch(command -> command.contains("motors")
                        || command.contains("robot.stand")
                        || command.contains("robot.walk(")
                        || command.contains("robot.turn(")
                        || command.contains(".val ="));
    }

    @Test
    void theFirstMotionSwitchesTheMotorsOnAndStandsTheDogUpWithANotice() {
        aibo.connect();

        aibo.move(20);

        assertThat(dog.received("motors on")).hasSize(1);
        assertThat(dog.received("robot.stand")).hasSize(1);
        assertThat(driven.notices).anyMatch(notice -> notice.contains("motors on"));
    }

    @Test
    void aWalkIsSentInPiecesOfAtMostTwoSeconds() {
        standing();
        aibo.connect();

        MotionReport report = aibo.move(200);

        assertThat(report.amount()).isEqualTo(Value.about(200, Unit.MM));
        assertThat(walked()).hasSize(2).allMatch(ms -> ms <= 2000);
        assertThat(walked().stream().mapToInt(ms -> ms).sum()).isCloseTo(2400, within(120));
        assertThat(aibo.state().pose().xMm()).isCloseTo(200, within(2.0));
    }

    @Test
    void backAndRightAreNegative() {
        standing();
        aibo.connect();

        assertThat(aibo.move(-25).amount()).isEqualTo(Value.about(-25, Unit.MM));
        assertThat(aibo.turn(-15).amount()).isEqualTo(Value.about(-15, Unit.DEG));

        assertThat(walked()).allMatch(ms -> ms < 0);
        assertThat(aibo.state().pose().headingDeg()).isCloseTo(-15, within(0.5));
    }

    @Test
    void theSettingsOfADogChangeHowLongItWalks() {
        standing();
        driven.settings.put("aibo." + dog.address().substring(2) + ".forward", "6.0");
        aibo.connect();

        aibo.move(100);

        assertThat(walked()).singleElement().satisfies(ms -> assertThat(ms).isCloseTo(600, within(35)));
    }

    @Test
    void aStopEndsTheWalkAndItsCaller() throws Exception {
        standing();
        aibo.connect();
        CompletableFuture<MotionReport> walk = dog.clock().aside(() -> aibo.move(2000));
        awaitSent("robot.walk");

        aibo.stop();

        assertThatThrownBy(() -> dog.clock().join(walk)).hasCauseInstanceOf(MotionStopped.class);
        assertThat(dog.received("stop walk")).isNotEmpty();
        assertThat(dog.received("robot.walk")).hasSize(1);
    }

    @Test
    void aStopThatOvertakesTheWalkIsRepeatedUntilItTakesEffect() {
        standing();
        aibo.connect();
        dog.latenessMs = 400;
        CompletableFuture<MotionReport> walk = dog.clock().aside(() -> aibo.move(2000));
        awaitSent("robot.walk");

        aibo.stop();

        assertThat(dog.hasWalked()).isTrue();
        assertThat(dog.isWalking()).isFalse();
        assertThat(dog.received("stop walk").size()).isGreaterThan(1);
        assertThatThrownBy(() -> dog.clock().join(walk)).hasCauseInstanceOf(MotionStopped.class);
        assertThat(dog.received("robot.walk")).hasSize(1);
    }

    @Test
    void aGuardEndsTheWalkAtOnce() throws Exception {
        standing();
        aibo.connect();
        CompletableFuture<MotionReport> walk = dog.clock()
                .aside(() -> aibo.move(2000, () -> aibo.get("distanceFront").number() < 250));
        awaitSent("robot.walk");

        dog.set("distanceNear.val", "15.000000");

        MotionReport report = dog.clock().join(walk);
        assertThat(report.amount()).isInstanceOf(Value.Number.class);
        assertThat(report.amount().number()).isLessThan(200);
        assertThat(dog.received("robot.walk")).hasSize(1);
    }

    @Test
    void aDriveUsesOneGaitAndExpires() throws Exception {
        standing();
        aibo.connect();

        aibo.drive(10, 30);

        awaitSent("stop turn");
        assertThat(walked()).isNotEmpty().allMatch(ms -> ms > 0 && ms <= 600);
        assertThat(dog.received("robot.walk")).isEmpty();
        assertThat(driven.notices).containsOnlyOnce("drives with its gait on the spot left");
    }

    @Test
    void settingAJointTakesTheGivenTime() {
        standing();
        aibo.connect();

        aibo.set("headPan", List.of(Value.of(30, Unit.DEG), Value.of(300, Unit.MS)));

        assertThat(dog.received("headPan.val = 30 time:300")).hasSize(1);
        assertThatThrownBy(() -> aibo.set("headPan", 120)).hasMessageContaining("-91 … 91");
    }

    @Test
    void aDogThatRefusesTheGuardWalksWithoutOne() {
        standing();
        dog.refusesGuards = true;
        aibo.connect();

        aibo.move(20);

        assertThat(walked()).hasSize(1);
    }

    @Test
    void aDogWithUrbi15IsWalkedReadAndStopped() {
        dog.speaks15 = true;
        standing();
        aibo.connect();

        MotionReport report = aibo.move(50);

        assertThat(report.amount()).isEqualTo(Value.about(50, Unit.MM));
        assertThat(aibo.get("version")).isEqualTo(Value.text("ERS-7, URBI 1.5"));
        assertThat(aibo.get("battery")).isEqualTo(Value.of(87, Unit.PERCENT));
        aibo.stop();
    }

    @Test
    void anEngineThatAnswersTwoSecondsLateIsConnectedReadAndStopped() {
        dog.slownessMs = 2000;
        standing();
        aibo.connect();

        assertThat(aibo.get("version")).isEqualTo(Value.text("ERS-7, URBI 1.0"));
        aibo.stop();
    }

    @Test
    void aLowBatteryIsReportedOnceAndNamedWhenTheConnectionIsLost() {
        aibo.connect();

        IntStream.iterate(22, percent -> percent >= 4, percent -> percent - 1).forEach(percent -> {
            dog.set("power()", percent / 100.0 + "0000");
            dog.say(SENSORS, "power", "*** Battery at " + percent + " %");
        });
        untilBattery(4);
        dog.hangUp();
        awaitLost();

        assertThat(driven.notices).containsOnlyOnce("the dog's battery is down to 19 %; it needs charging soon");
        assertThat(driven.notices).noneMatch(notice -> notice.contains("18 %"));
        assertThatThrownBy(() -> aibo.move(10)).hasMessageEndingWith("its battery was at 4 %");
    }

    @Test
    void silenceStopsTheWalkAndThenCountsAsLost() {
        standing();
        aibo.connect();
        CompletableFuture<MotionReport> walk = dog.clock().aside(() -> aibo.move(2000));
        awaitSent("robot.walk");

        dog.answersPolls = false;

        assertThatThrownBy(() -> dog.clock().join(walk)).hasMessageContaining("no message from the dog");
        awaitSent("stop walk");
    }

    @Test
    void aClosedConnectionEndsTheWalkAndTheDogCanBeConnectedAgain() {
        standing();
        aibo.connect();
        CompletableFuture<MotionReport> walk = dog.clock().aside(() -> aibo.move(2000));
        awaitSent("robot.walk");

        dog.hangUp();

        assertThatThrownBy(() -> dog.clock().join(walk)).hasCauseInstanceOf(LinkLost.class);
        aibo.connect();
        assertThat(aibo.isConnected()).isTrue();
        assertThat(dog.received("robot.walk")).hasSize(1);
    }

    @Test
    void aPeerThatIsNoUrbiServerIsReportedInTime() {
        dog.introducesItself = false;

        assertThatThrownBy(aibo::connect)
                .isInstanceOf(BotException.class)
                .hasMessageContaining("not as an URBI server within 4 s");
    }

    @Test
    void theAddressOfAnotherRobotTypeIsRefused() {
        assertThatThrownBy(() -> new MajicAibo("pioneer://host"))
                .hasMessageContaining("it looks like aibo://192.168.1.20");
        assertThatThrownBy(() -> new MajicAibo("aibo:COM3")).hasMessageContaining("not an Aibo's address");
    }

    private void untilBattery(int percent) {
        dog.clock().until(() -> aibo.get("battery").equals(Value.of(percent, Unit.PERCENT)));
    }

    private void awaitLost() {
        dog.clock().until(() -> !aibo.isConnected());
    }

    private void standing() {
        dog.set("robot.MyguessPosition()", "\"stand\"");
        dog.set("legLF1.load", "1.000000");
    }

    private List<Integer> walked() {
        return dog.received("robot.").stream()
                .filter(command -> command.contains("walk(") || command.contains("turn("))
                .map(command -> Integer.parseInt(command.replaceAll(".*\\((-?\\d+)\\).*", "$1")))
                .toList();
    }

    private void awaitSent(String words) {
        dog.awaitReceived(words);
    }
}
