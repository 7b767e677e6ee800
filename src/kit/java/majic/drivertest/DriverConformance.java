package majic.drivertest;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Value;
import org.junit.jupiter.api.Test;

/**
 * Tests that a driver does what programs, acts and STOP rely on, whatever the robot: a driver's test class extends this
 * one and provides the robot. The robot needs {@link #moveMm()} twice ahead of it, and as much behind and beside it.
 */
public abstract class DriverConformance extends RobotTest {
    /** Called by JUnit. */
    protected DriverConformance() {}

    @Test
    void connectingMovesNothingAndReturnsWithReadings() {
        Pose start = robot.truePose();

        bot.connect();

        assertNotEquals(BotState.UNKNOWN, bot.state(), "no state was published before connect() returned");
        assertFalse(bot.state().moving(), "the robot is reported as moving");
        sensors().forEach(this::assertKnown);
        assertStaysAt(start, 2);
    }

    private void assertKnown(String parameter) {
        assertFalse(bot.get(parameter) instanceof Value.Unknown, parameter + " = " + bot.get(parameter));
    }

    @Test
    void everyParameterCanBeReadAndIsDescribed() {
        bot.connect();
        pass(1);
        for (Parameter parameter : bot.parameters()) {
            String name = parameter.name();
            assertFalse(parameter.help().isBlank(), name + " has no explanation");
            try {
                assertTrue(bot.get(name) != null, name + " is null");
            } catch (BotException e) {
                assertTrue(String.valueOf(e.getMessage()).contains(name), name + " fails: " + e.getMessage());
            }
        }
    }

    @Test
    void movesAreInMillimetresAndAheadIsPositive() {
        bot.connect();

        assertMoves(moveMm());
        assertMoves(-moveMm());
    }

    private void assertMoves(double mm) {
        Pose start = robot.truePose();
        Pose reported = bot.state().pose();
        MotionReport report = bot.move(mm);
        Pose end = robot.truePose();
        assertNear(mm, aheadMm(start, end), SMALL_MM, "move " + mm + " went");
        assertNear(aheadMm(start, end), number(report), SMALL_MM, "move " + mm + " reports");
        assertSettled(end);
        assertNear(
                aheadMm(start, end), aheadMm(reported, bot.state().pose()), SMALL_MM, "the reported pose has moved by");
    }

    @Test
    void motionsOfLengthZeroAreDone() {
        bot.connect();
        Pose start = robot.truePose();

        assertEquals(0, number(bot.move(0)), SMALL_MM);
        assertEquals(0, number(bot.turn(0)), SMALL_DEG);
        assertStaysAt(start, 1);
    }

    @Test
    void turnsAreInDegreesAndToTheLeftIsPositive() {
        bot.connect();

        assertTurns(90);
        assertTurns(-60);
    }

    private void assertTurns(double degrees) {
        Pose start = robot.truePose();
        Pose reported = bot.state().pose();
        MotionReport report = bot.turn(degrees);
        Pose end = robot.truePose();
        assertNear(degrees, turnedDeg(start, end), SMALL_DEG, "turn " + degrees + " turned");
        assertNear(turnedDeg(start, end), number(report), SMALL_DEG, "turn " + degrees + " reports");
        assertSettled(end);
        assertNear(
                turnedDeg(start, end),
                turnedDeg(reported, bot.state().pose()),
                SMALL_DEG,
                "the reported heading has changed by");
    }

    /** When a motion returns, the robot is stationary and reported as such. */
    private void assertSettled(Pose end) {
        assertStaysAt(end, 0.5);
        assertFalse(bot.state().moving(), "the robot is reported as moving after its motion");
    }

    /** Connects a robot whose motors are on: the first motion may take longer, because it switches them on. */
    private void connectReady() {
        bot.connect();
        bot.move(moveMm() / 6);
    }

    @Test
    void aDriveGoesAheadAndTurnsLeftUntilItIsNoLongerRenewed() {
        connectReady();
        double mmPerSec = bot.profile().cruiseMmPerSec();
        double degPerSec = bot.profile().cruiseTurnDegPerSec();

        double aheadMm = aheadMm(robot.truePose(), drive(mmPerSec, 0));
        double backMm = aheadMm(robot.truePose(), drive(-mmPerSec, 0));
        double leftDeg = turnedDeg(robot.truePose(), drive(0, degPerSec));

        assertAll(
                () -> assertWithin(0.4 * mmPerSec, 4 * mmPerSec, aheadMm, "mm ahead"),
                () -> assertWithin(-4 * mmPerSec, -0.4 * mmPerSec, backMm, "mm back"),
                () -> assertWithin(0.4 * degPerSec, 4 * degPerSec, leftDeg, "degrees to the left"));
    }

    /** Drives for 1.5 s and checks the state meanwhile; returns where the robot comes to a stop by itself. */
    private Pose drive(double mmPerSec, double degPerSec) {
        for (int call = 0; call < 5; call++) {
            bot.drive(mmPerSec, degPerSec);
            pass(0.3);
        }
        BotState state = bot.state();
        assertTrue(state.moving(), "a robot that drives is not reported as moving");
        assertTrue(mmPerSec * state.speedMmPerSec() >= 0, "speed has the wrong sign: " + state.speedMmPerSec());
        assertTrue(
                degPerSec * state.turnRateDegPerSec() >= 0,
                "turnRate has the wrong sign: " + state.turnRateDegPerSec());
        pass(PROMPT_S);
        assertStaysAt(robot.truePose(), 1);
        return robot.truePose();
    }

    @Test
    void aTimedDriveLastsItsTime() {
        connectReady();
        double mmPerSec = bot.profile().cruiseMmPerSec();
        Pose start = robot.truePose();

        bot.drive(mmPerSec, 0, 2, Guard.NEVER);

        assertWithin(0.8 * mmPerSec, 4 * mmPerSec, aheadMm(start, robot.truePose()), "mm");
        assertStaysAt(robot.truePose(), 1);
    }

    @Test
    void aStopOvertakesTheMotionAndThoseThatWait() {
        bot.connect();
        Running motion = begin(() -> bot.move(2 * moveMm()));
        Running waiting = begin(() -> bot.turn(90));
        awaitMotion();
        Pose here = robot.truePose();

        double before = seconds();
        bot.stop();

        assertWithin(0, PROMPT_S, seconds() - before, "s for the stop");
        assertInstanceOf(MotionStopped.class, motion.end());
        assertInstanceOf(MotionStopped.class, waiting.end());
        assertWithin(-SETTLED_MM, brakingMm(), here.distanceMm(robot.truePose()), "mm behind the stop");
        assertStaysAt(robot.truePose(), 2);
    }

    @Test
    void aStopEndsADriveAndTheNextMotionIsPossible() {
        connectReady();
        bot.drive(bot.profile().cruiseMmPerSec(), 0);
        pass(0.4);

        bot.stop();

        assertStaysAt(robot.truePose(), 1);
        bot.move(moveMm() / 2);
    }

    @Test
    void anInterruptedThreadStopsItsMotion() {
        bot.connect();
        Running motion = begin(() -> bot.move(2 * moveMm()));
        awaitMotion();

        motion.thread.interrupt();

        assertInstanceOf(MotionStopped.class, motion.end());
        pass(PROMPT_S);
        assertStaysAt(robot.truePose(), 1);
    }

    @Test
    void aGuardThatHoldsAlreadyPreventsTheMotion() {
        bot.connect();
        Pose start = robot.truePose();

        bot.move(moveMm(), () -> true);

        assertStaysAt(start, 2);
    }

    @Test
    void aGuardEndsTheMotionAtTheReadingThatMakesItTrue() {
        bot.connect();
        Pose start = robot.truePose();
        Pose reported = bot.state().pose();

        MotionReport report =
                bot.move(2 * moveMm(), () -> aheadMm(reported, bot.state().pose()) > moveMm() / 2);

        double mm = aheadMm(start, robot.truePose());
        assertWithin(moveMm() / 2 - SMALL_MM, moveMm() / 2 + brakingMm() + SMALL_MM, mm, "mm until the guard held");
        assertNear(mm, number(report), SMALL_MM, "the motion reports");
        assertStaysAt(robot.truePose(), 1);
    }

    @Test
    void aGuardThatFailsStopsTheMotion() {
        bot.connect();
        Pose reported = bot.state().pose();
        Guard failing = () -> {
            if (aheadMm(reported, bot.state().pose()) > moveMm() / 4) {
                throw new BotException("the guard cannot be evaluated");
            }
            return false;
        };

        assertThrows(MotionFailed.class, () -> bot.move(2 * moveMm(), failing));

        pass(PROMPT_S);
        assertStaysAt(robot.truePose(), 1);
    }

    @Test
    void aLostLinkEndsTheMotionAndAfterwardsNothingMovesUntilItIsCommanded() {
        bot.connect();
        Running motion = begin(() -> bot.move(2 * moveMm()));
        Running waiting = begin(() -> bot.turn(90));
        awaitMotion();

        robot.cut();

        assertInstanceOf(LinkLost.class, motion.end());
        assertInstanceOf(LinkLost.class, waiting.end());
        assertEquals(MajicBot.Connection.LOST, bot.connection());
        assertThrows(LinkLost.class, () -> bot.move(moveMm()));

        bot.connect();
        pass(PROMPT_S);
        assertStaysAt(robot.truePose(), 2);
        bot.move(moveMm() / 4);
    }

    @Test
    void aMovingRobotThatFallsSilentEndsItsMotionAndIsLost() {
        bot.connect();
        Running motion = begin(() -> bot.move(2 * moveMm()));
        awaitMotion();

        robot.fallSilent();

        awaitLoss();
        assertInstanceOf(BotException.class, motion.end());
        assertThrows(LinkLost.class, () -> bot.move(moveMm()));
    }

    @Test
    void aStationaryRobotThatFallsSilentIsLost() {
        bot.connect();
        pass(1);

        robot.fallSilent();

        awaitLoss();
        assertFalse(bot.lostReason().orElse("").isBlank(), "the loss has no reason");
    }

    private void awaitLoss() {
        double start = seconds();
        while (bot.connection() != MajicBot.Connection.LOST) {
            assertWithin(0, lostWithinS(), seconds() - start, "s without a report, and the robot is not lost");
            pass(0.05);
        }
    }

    @Test
    void aMotionThatAnObstaclePreventsEndsAndTheMotorsStop() {
        connectReady();
        robot.block();
        Running motion = begin(() -> bot.move(moveMm()));

        Throwable end = motion.end();

        if (noticesObstacles()) {
            assertInstanceOf(MotionFailed.class, end);
        }
        robot.unblock();
        assertStaysAt(robot.truePose(), 2);
    }

    @Test
    void closingStopsTheRobotForGood() {
        bot.connect();
        Running motion = begin(() -> bot.move(2 * moveMm()));
        awaitMotion();

        bot.close();

        assertInstanceOf(BotException.class, motion.end());
        pass(PROMPT_S);
        assertStaysAt(robot.truePose(), 1);
        assertEquals(MajicBot.Connection.CLOSED, bot.connection());
        assertThrows(BotException.class, () -> bot.move(moveMm()));
        assertThrows(BotException.class, bot::connect);
        bot.close();
    }
}
