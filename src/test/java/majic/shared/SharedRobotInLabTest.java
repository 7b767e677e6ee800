package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Value;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.RobotMessage;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests two programs over one broker: Anna at desk1 uses the Pioneer that Bert has at desk2. */
class SharedRobotInLabTest {
    private static final String REQUESTS = "lab/majic/1/desks/desk2/robots/1/request";

    @AutoClose
    private final TwoDesks desks = new TwoDesks();

    private TwoDesks.Desk anna;

    @BeforeEach
    void useThePioneer() {
        anna = desks.user("desk1", "Anna");
    }

    @Test
    void movesAndTurnsAreAnsweredAsThoseOfARobotOfThisDesk() throws InterruptedException {
        Pose start = desks.truePose();

        List<String> said = anna.run("1 move 300", "1 turn 90", "1 get desk,bumped");

        assertThat(said).anySatisfy(line -> assertThat(line).matches("1 move 300: done \\((29|30)\\d mm, .* s\\)"));
        assertThat(said).anySatisfy(line -> assertThat(line).matches("1 turn 90: done \\((89|90|91).* deg, .* s\\)"));
        assertThat(said).contains("1 desk = desk2", "1 bumped = no");
        assertThat(desks.truePose().distanceMm(start)).isCloseTo(300, within(10.0));
    }

    @Test
    void theRobotHasTheTypeAndTheNameOfItsMake() {
        assertThat(anna.bot.type().name()).isEqualTo("pioneer");
        assertThat(anna.robot().label()).isEqualTo("Pioneer (desk2)");
        assertThat(anna.bot.introduction()).startsWith("a MobileRobots Pioneer").endsWith("at desk2");
    }

    @Test
    void aGuardOnTheRobotsOwnReadingsIsEvaluatedAtItsDesk() throws InterruptedException {
        anna.run("1 move 4000 until distanceFront < 1000");

        assertThat(Double.parseDouble(
                        desks.pioneer.get("distanceFront").toString().replace(" mm", "")))
                .isBetween(800.0, 1000.0);
        assertThat(desks.broker.published(REQUESTS))
                .extracting(BrokerMessage::text)
                .anySatisfy(request -> assertThat(request).contains("\"until\":\"distanceFront < 1000\""));
    }

    @Test
    void placingTheRobotAtItsDeskMovesItHereAndChangesNoOdometry() throws InterruptedException {
        anna.run("1 move 200");
        desks.pioneer.place(new Pose(3000, -2000, 90));
        desks.pass(1);
        desks.pioneer.place(new Pose(1000, 500, 180));
        desks.pass(1);

        Pose here = anna.bot.state().pose();
        assertThat(here.distanceMm(new Pose(1000, 500, 180))).isLessThan(1);
        assertThat(Math.abs(here.headingDeg())).isCloseTo(180, within(0.1));
        assertThat(here.seenFrom(anna.bot.odometryOrigin()).xMm()).isCloseTo(200, within(10.0));
    }

    @Test
    void settingsAreThoseOfTheDesk() throws InterruptedException {
        anna.run("1 set cruise 150", "1 set maxMove 400");

        assertThat(desks.pioneer.get("cruise")).hasToString("150 mm/s");
        assertThat(anna.run("1 move 500")).anySatisfy(line -> assertThat(line).contains("longer than maxMove, 400 mm"));
    }

    @Test
    void stopOfTheTeamStopsTheRobotAndLatchesBothDesks() throws InterruptedException {
        anna.say("1 move 4000");
        desks.pass(2);

        anna.team.stopAll();
        desks.pass(1.5);

        assertThat(desks.desk2.team().isLatched()).isTrue();
        assertThat(desks.movesWithin(2)).isLessThan(1);
        anna.team.release();
        desks.pass(0.5);
        assertThat(desks.desk2.team().isLatched()).isFalse();
        assertThat(desks.movesWithin(2)).isLessThan(1);
    }

    @Test
    void stopAtTheDeskOfTheRobotLatchesThisOne() throws InterruptedException {
        anna.say("1 move 4000");
        desks.pass(2);

        desks.desk2.team().stopAll();
        desks.pass(1.5);

        assertThat(anna.team.isLatched()).isTrue();
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("STOP by Bert at desk2"));
        assertThat(desks.movesWithin(2)).isLessThan(1);
    }

    /** Adds the Aibo at desk2, and connects to it from this desk. */
    private MajicBot sharedAibo() throws InterruptedException {
        desks.desk2.add("aibo");
        desks.pass(1);
        MajicBot dog = robotAt("mqtt://broker/lab/desk2/2");
        dog.connect();
        return dog;
    }

    @Test
    void stopReachesADeskThatHasConnectedSeveralTimes() throws InterruptedException {
        try (MajicBot dog = sharedAibo()) {
            assertThat(dog.isConnected()).isTrue();

            desks.desk2.team().stopAll();
            desks.pass(1);

            assertThat(anna.team.isLatched()).isTrue();
        }
    }

    @Test
    void stopReachesADeskThatHasRemovedSomeOfItsRobotsOrAll() throws InterruptedException {
        try (MajicBot dog = sharedAibo()) {
            assertThat(dog.isConnected()).isTrue();
            anna.run("remove 1");
            desks.desk2.team().stopAll();
            desks.pass(1);
            assertThat(anna.team.isLatched()).isTrue();
        }
        anna.run("release");
        desks.pass(1);
        assertThat(desks.desk2.team().isLatched()).isFalse();
        desks.desk2.team().stopAll();
        desks.pass(1);

        assertThat(anna.team.isLatched()).isTrue();
    }

    @Test
    void stopAtADeskWithoutRobotsStopsTheSiteThatItHasUsed() throws InterruptedException {
        anna.run("remove 1");
        assertThat(anna.team.members()).isEmpty();
        desks.desk2.say("1 move 4000");
        desks.pass(2);

        anna.run("stop");
        desks.pass(1.5);

        assertThat(anna.team.isLatched()).isTrue();
        assertThat(desks.desk2.team().isLatched()).isTrue();
        assertThat(desks.movesWithin(2)).isLessThan(1);
        anna.run("release");
        desks.pass(0.5);
        assertThat(desks.desk2.team().isLatched()).isFalse();
    }

    @Test
    void aDeskThatLeavesItsSitesOrCouldNotConnectObeysNoStop() throws InterruptedException {
        assertThatThrownBy(() -> robotAt("mqtt://broker/school/desk2/1").connect())
                .isInstanceOf(BotException.class);
        anna.run("remove 1");
        anna.type.leaveSites();

        desks.desk2.team().stopAll();
        desks.pass(1);

        assertThat(anna.team.isLatched()).isFalse();
        assertThat(anna.team.stopAllIfAny()).isFalse();
        assertThat(anna.connection().isConnected()).isFalse();
    }

    @Test
    void onlyOneDeskHoldsTheRobot() throws InterruptedException {
        TwoDesks.Desk carl = desks.user("desk3", "Carl");
        anna.run("1 hold");

        List<String> refused = carl.run("1 move 300", "1 get holder");

        assertThat(refused).anySatisfy(line -> assertThat(line).contains("Anna at desk1"));
        assertThat(carl.bot.remoteHolder()).contains("Anna at desk1");
        assertThat(anna.bot.remoteHolder()).isEmpty();
        assertThat(desks.desk2.run("1 move 300"))
                .anySatisfy(line -> assertThat(line).contains("Anna at desk1"));
        anna.run("1 move 200", "1 free");
        assertThat(carl.run("1 move 200")).anySatisfy(line -> assertThat(line).contains("1 move 200: done"));
    }

    @Test
    void aRefusedMotionDoesNotStopTheHolder() throws InterruptedException {
        TwoDesks.Desk carl = desks.user("desk3", "Carl");
        anna.say("1 move 2000");
        desks.pass(1.5);

        carl.run("1 move 300");

        assertThat(desks.movesWithin(1)).isGreaterThan(50);
        assertThatThrownBy(() -> carl.bot.drive(100, 0))
                .isInstanceOf(BotException.class)
                .hasMessageContaining("Anna at desk1");
        assertThat(desks.movesWithin(1)).isGreaterThan(50);
    }

    @Test
    void anyoneMayStopTheRobotAndTheHoldersActEnds() throws InterruptedException {
        TwoDesks.Desk carl = desks.user("desk3", "Carl");
        anna.say("1 act PioneerWander");
        desks.pass(6);
        assertThat(anna.robot().owner()).isNotNull();

        carl.run("1 stop");
        desks.pass(1);

        assertThat(desks.movesWithin(3)).isLessThan(1);
        assertThat(anna.robot().owner()).isNull();
    }

    @Test
    void aScriptOfTheDeskThatUsesTheRobotEndsWhenItIsStoppedThere() throws InterruptedException {
        anna.say("repeat 20", "1 move 100", "wait 8s", "end");
        desks.pass(2.5);
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("1 move 100: done"));

        desks.desk2.run("1 stop");

        assertThat(desks.movesWithin(20)).isLessThan(1);
    }

    @Test
    void aStopWhoseAnswerWasLostHidesNoLaterStopOfOthers() throws InterruptedException {
        anna.connection().holdBack();
        WaitPolicy.without(() -> {
            anna.bot.drive(100, 0);
            anna.bot.stop();
        });
        anna.connection().drop();
        desks.pass(2.5);
        anna.bot.connect();
        anna.say("repeat 20", "1 move 100", "wait 8s", "end");
        desks.pass(3);
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("1 move 100: done"));

        desks.desk2.run("1 stop");

        assertThat(desks.movesWithin(20)).isLessThan(1);
    }

    @Test
    void theHoldersOwnStopEndsNothingElse() throws InterruptedException {
        anna.run("1 hold", "1 stop");
        anna.bot.drive(100, 0);
        desks.pass(2);

        assertThat(anna.run("1 move 200", "1 get holder"))
                .anySatisfy(line -> assertThat(line).contains("1 move 200: done"))
                .contains("1 holder = this program");
    }

    @Test
    void aCutNetworkStopsTheRobotAndNothingResumes() throws InterruptedException {
        anna.say("1 move 4500");
        desks.pass(2);

        anna.connection().cut();
        desks.pass(1.5);

        assertThat(desks.movesWithin(2)).isLessThan(1);
        assertThat(anna.bot.connection()).isEqualTo(Connection.LOST);
        anna.connection().restore();
        desks.pass(2);
        anna.bot.connect();
        assertThat(desks.movesWithin(3)).isLessThan(1);
        assertThat(anna.run("1 move 100")).anySatisfy(line -> assertThat(line).contains("1 move 100: done"));
    }

    @Test
    void aProgramThatStallsForTwoSecondsLosesItsHoldAndNotItsConnection() throws InterruptedException {
        anna.say("1 move 4500");
        desks.pass(2);

        anna.connection().cut();
        desks.pass(2);
        anna.connection().restore();
        desks.pass(0.5);

        assertThat(anna.bot.connection()).isEqualTo(Connection.CONNECTED);
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("1 move 4500: stopped"));
        assertThat(desks.movesWithin(3)).isLessThan(1);
        assertThat(anna.run("1 move 100")).anySatisfy(line -> assertThat(line).contains("1 move 100: done"));
    }

    @Test
    void aDeskWhoseNetworkIsCutIsLostWithinThreeSeconds() throws InterruptedException {
        desks.ofDesk2.get(0).holdBack();

        desks.pass(3);

        assertThat(anna.bot.connection()).isEqualTo(Connection.LOST);
    }

    @Test
    void whatIsDeliveredLateMovesNothing() throws InterruptedException {
        anna.connection().holdBack();
        anna.say("1 move 1000");
        desks.pass(1.5);

        anna.connection().deliver();

        assertThat(desks.movesWithin(4)).isLessThan(1);
        assertThat(anna.said()).anySatisfy(line -> assertThat(line).contains("too late"));
    }

    @Test
    void aKilledDeskLeavesNoRobotInMotion() throws InterruptedException {
        anna.say("1 move 4500");
        desks.pass(2);

        anna.connection().kill();
        desks.pass(2);

        assertThat(desks.movesWithin(2)).isLessThan(1);
    }

    @Test
    void theLossOfTheDeskIsNoticedWithinThreeSeconds() throws InterruptedException {
        desks.ofDesk2.get(0).kill();
        desks.pass(0.5);

        assertThat(anna.bot.connection()).isEqualTo(Connection.LOST);
        assertThat(anna.bot.lostReason()).contains("desk2 has lost its connection to the broker");
    }

    @Test
    void theLossOfTheRobotAtItsDeskIsReportedAndItIsUsedAgainAfterwards() throws InterruptedException {
        desks.desk2.lab().simulators().faults("pioneer").cut();
        desks.pass(2);

        assertThat(anna.bot.connection()).isEqualTo(Connection.LOST);
        assertThat(anna.bot.lostReason().orElse("")).startsWith("desk2 has lost its connection to the robot");
        assertThatThrownBy(anna.bot::connect).hasMessageContaining("desk2 is not connected to its robot 1");
        desks.pioneer.connect();
        desks.pass(1.5);
        anna.bot.connect();
        assertThat(anna.run("1 move 100")).anySatisfy(line -> assertThat(line).contains("1 move 100: done"));
    }

    @Test
    void allRobotsOfABrokerUseOneConnection() throws InterruptedException {
        desks.desk2.add("aibo");
        desks.pass(1);
        MajicBot dog = anna.type.create(BotAddress.parse("mqtt://broker/lab/desk2/2"), desks.environment);
        try (dog) {
            dog.connect();

            assertThat(dog.type().name()).isEqualTo("aibo");
            assertThat(anna.connections).hasSize(1);
        }
        assertThat(anna.connection().isConnected()).isTrue();
    }

    @Test
    void aRobotThatIsNotThereIsExplained() {
        assertThatThrownBy(() -> robotAt("mqtt://broker/lab/desk2/7").connect())
                .hasMessageContaining("desk2 shares no robot 7 (it shares 1)");
        assertThatThrownBy(() -> robotAt("mqtt://broker/lab/desk9/1").connect())
                .hasMessageContaining("no desk desk9 shares robots at mqtt://broker/lab");
    }

    @Test
    void anAddressWithASlashAtTheEndListsTheRobotsOfASiteOrADesk() throws InterruptedException {
        desks.desk2.add("aibo");
        desks.pass(1);

        assertThatThrownBy(robotAt("mqtt://broker/lab/")::connect)
                .hasMessage("which robot is it: mqtt://broker/lab/desk2/1 (MobileRobots Pioneer),"
                        + " mqtt://broker/lab/desk2/2 (Sony Aibo ERS-7)?");
        assertThatThrownBy(robotAt("mqtt://broker/lab/desk2/")::connect)
                .hasMessageStartingWith("which robot is it: mqtt://broker/lab/desk2/1 (MobileRobots Pioneer)");
        assertThatThrownBy(robotAt("mqtt://broker/school/")::connect)
                .hasMessageStartingWith("no desk shares a robot there")
                .hasMessageContaining("--share mqtt://broker/school --desk NAME");
    }

    @Test
    void withoutTheBrokerNothingIsKnownOfTheHolderAndTheReadings() throws InterruptedException {
        assertThat(anna.run("1 move 100", "1 get holder")).contains("1 holder = this program");
        desks.broker.stop();
        desks.pass(1);

        assertThat(anna.bot.isConnected()).isFalse();
        assertThat(anna.bot.get("holder")).isEqualTo(Value.unknown("connection lost"));
        assertThat(anna.bot.get("delay")).isEqualTo(Value.unknown("connection lost"));
        assertThat(anna.bot.get("voltage")).isInstanceOf(Value.Unknown.class);
    }

    @Test
    void linesOfAnotherDeskAreLimitedAndTheOthersCounted() throws InterruptedException {
        for (int line = 0; line < 5000; line++) {
            desks.broker.publish(BrokerMessage.json(
                    "lab/majic/1/desks/desk2/robots/1/messages",
                    new RobotMessage(RobotMessage.Kind.MESSAGE, "line " + line).toJson(),
                    Quality.AT_LEAST_ONCE));
        }
        desks.pass(2);

        assertThat(anna.said().stream().filter(line -> line.contains("line "))).hasSizeLessThan(60);
        assertThat(anna.said())
                .anyMatch(line -> line.matches("1: \\d+ lines of desk2 left out: more arrive than can be" + " read"));
    }

    @Test
    void aUserWithoutTheRightToSendHeartbeatsIsToldWhatHappens() throws InterruptedException {
        anna.connection().refuse("lab/majic/1/desks/+/robots/+/hold");
        anna.say("1 move 2000");
        desks.pass(3);

        assertThat(anna.said())
                .anyMatch(line -> line.contains("the broker refuses the heartbeats of its holder (not authorized)"));
    }

    private MajicBot robotAt(String address) {
        return anna.type.create(BotAddress.parse(address), desks.environment);
    }
}
