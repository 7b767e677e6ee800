package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/**
 * Tests the effect of one line and its answers. Robot 1 is an Aibo, 2 a Pioneer; both move at 300 mm/s and 90 deg/s.
 */
class RobotCommandsTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @Test
    void moveAnswersWithTheDistanceAndTheTime() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300")).containsExactly("1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void theCallFormIsAnsweredInTheSameWay() throws InterruptedException {
        assertThat(fixture.runPipe("1.move(300)", "2.set(headPan, 30)", "1,2.turn( 90 )", "1.get(x)"))
                .contains(
                        "1 move 300: done (300 mm, 1.0 s)",
                        "2 set headPan 30: done",
                        "2 turn 90: done (90 deg, 1.0 s)");
        assertThat(fixture.bot(1).sent()).containsExactly("move 300", "turn 90");
    }

    @Test
    void wordsIgnoreCaseAndUnitsAreConverted() throws InterruptedException {
        assertThat(fixture.runPipe("ALL Move -0.3M  # backward"))
                .containsExactlyInAnyOrder(
                        "1 move -0.3M: done (-300 mm, 1.0 s)", "2 move -0.3M: done (-300 mm, 1.0 s)");
    }

    @Test
    void aListARangeAndATypeChooseRobots() throws InterruptedException {
        fixture.runPipe("1,2 move 30", "1-9 move 60", "pioneer move 90");
        assertThat(fixture.bot(1).sent()).containsExactly("move 30", "move 60");
        assertThat(fixture.bot(2).sent()).containsExactly("move 30", "move 60", "move 90");
    }

    @Test
    void robotsOfOneLineMoveAtTheSameTime() throws InterruptedException {
        long began = fixture.time.nanos();
        fixture.runPipe("1,2 move 300");
        assertThat(fixture.time.secondsSince(began)).isBetween(0.99, 1.1);
    }

    @Test
    void getPrintsALineForEachParameter() throws InterruptedException {
        fixture.bot(1).putObstacle(432);
        assertThat(fixture.runPipe("1 get distancefront,voltage", "2 get distanceFront"))
                .containsExactlyInAnyOrder("1 distanceFront = 432 mm", "1 voltage = 12.6 V", "2 distanceFront = clear");
    }

    @Test
    void setTakesSeveralValuesAndChecksThem() throws InterruptedException {
        assertThat(fixture.runPipe("1 set headPan 30 500ms", "1 set title \"a # b\"", "all set light on"))
                .contains("1 set headPan 30 500ms: done", "1 set title \"a # b\": done", "2 set light on: done");
        assertThat(fixture.bot(1).get("title")).isEqualTo(Value.text("a # b"));
    }

    @Test
    void driveLastsOneSecondByDefault() throws InterruptedException {
        assertThat(fixture.runPipe("1 drive 100 20", "1 drive 100 20 for 2.5s"))
                .containsExactly("1 drive 100 20: done (1.0 s)", "1 drive 100 20 for 2.5s: done (2.5 s)");
    }

    @Test
    void untilEndsAMotionAtTheReadingThatShowsIt() throws InterruptedException {
        fixture.bot(1).putObstacle(1000);
        assertThat(fixture.runPipe("1 move 2m until distanceFront < near"))
                .containsExactly("1 move 2m until distanceFront < near: done (510 mm, 1.7 s)");
    }

    @Test
    void untilWatchesOtherRobotsAsWell() throws InterruptedException {
        assertThat(fixture.runPipe("2 move 300", "1 move 3m until 2 x >= 150"))
                .anyMatch(line -> line.startsWith("1 move 3m until 2 x >= 150: done (") && line.endsWith("0.5 s)"));
    }

    @Test
    void anUnknownReadingEndsAGuardedMotionWithTheReason() throws InterruptedException {
        fixture.bot(1).tell("distanceFront", Value.unknown("no reading yet"));
        assertThat(fixture.runPipe("1 move 1m until distanceFront < 300"))
                .containsExactly("1 move 1m until distanceFront < 300: failed: until is undecided: "
                        + "distanceFront is unknown (no reading yet)");
    }

    @Test
    void whatIsQueuedBehindAFailureIsNotRun() throws InterruptedException {
        fixture.bot(1).stallAfter(120);
        assertThat(fixture.runPipe("1 move 200", "1 move 100", "2 move 30"))
                .contains(
                        "1 move 200: failed: stalled after 120 mm",
                        "1 move 100: not run: 1 move 200 failed",
                        "2 move 30: done (30 mm, 0.1 s)");
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void aLostLinkIsAnswered() throws InterruptedException {
        fixture.pipe.parseText("1 move 300");
        fixture.pause(0.5);
        fixture.bot(1).cut();
        fixture.pipe.awaitAll();
        assertThat(fixture.answers()).contains("1 move 300: failed: connection lost");
    }

    @Test
    void getShowsAnOldReadingOnlyWithItsAge() throws InterruptedException {
        fixture.pause(1);
        fixture.bot(1).tell("voltage", Value.of(12.3, Unit.V));
        fixture.bot(1).reportSpeed(0);
        fixture.bot(1).cut();
        fixture.pause(3);

        assertThat(fixture.runPipe("1 get voltage,maxMove"))
                .anyMatch(line -> line.matches(
                        "1 voltage = unknown \\(connection lost; 12.3 V at the last report, \\d[\\d.]* s ago\\)"));
        assertThat(fixture.answers()).contains("1 maxMove = 5000 mm");
    }

    @Test
    void getNowFailsWithoutANewReading() throws InterruptedException {
        fixture.pause(1);
        fixture.bot(1).reportSpeed(0);
        fixture.bot(1).cut();
        fixture.pause(3);

        assertThat(fixture.runPipe("1 get now x,distanceFront,moving"))
                .last()
                .asString()
                .matches("1 get now x,distanceFront,moving: failed: connection lost; at the last report,"
                        + " \\d[\\d.]* s ago: x = 0 mm, distanceFront = clear, moving = no");
        assertThat(fixture.pipe.allSucceeded()).isFalse();
    }

    @Test
    void aConditionUsesNoOldReading() throws InterruptedException {
        fixture.bot(2).cut();

        assertThat(fixture.runPipe("if 2 x > 100", "1 move 30", "end"))
                .last()
                .asString()
                .endsWith("2 x is unknown (connection lost)");
        assertThat(fixture.runPipe("if 2 maxMove > 100", "1 move 30", "end"))
                .last()
                .isEqualTo("1 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void aTypesOwnCommandRunsAndAnswers() throws InterruptedException {
        assertThat(fixture.runPipe("1 wag 3", "1 bark gladly 100ms 0.3s 200ms 0"))
                .containsExactly(
                        "1 wag 3: wagged 3",
                        "1 bark gladly 100ms 0.3s 200ms 0: barked [gladly, 100 ms, 300 ms, 200 ms, 0 ms]");
    }

    @Test
    void readingsOfTwoRobotsAreComparedByTheirOwn() throws InterruptedException {
        fixture.bot(2).tell("voltage", Value.of(11.2, Unit.V));
        assertThat(fixture.runPipe("if 2 voltage < 11.5 or any bumped == yes", "1 move 30", "else", "2 move 30", "end"))
                .containsExactly("1 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void helpNamesCommandsAndParameters() {
        assertThat(fixture.prompt.parseText("1 help headPan")).isEmpty();
        assertThat(fixture.answers())
                .containsExactly(
                        "1 headPan (-91 … 91 deg; get set; moves the robot; then time 0 … 10 s): where the head looks, left"
                                + " positive");
    }

    @Test
    void robotsMayHaveNoBehaviourToEnd() throws InterruptedException {
        assertThat(fixture.runPipe("1 act off")).containsExactly("1 act off: no act runs on it");
    }
}
