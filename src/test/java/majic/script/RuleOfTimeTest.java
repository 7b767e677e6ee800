package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Commands to one robot run in order, different robots run side by side, a wait joins them. */
class RuleOfTimeTest {
    @AutoClose
    private final ScriptFixture fixture = ScriptFixture.withTwo();

    @Test
    void linesToOneRobotFollowEachOther() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300", "1 turn 90", "1 get x"))
                .containsExactly("1 move 300: done (300 mm, 1.0 s)", "1 turn 90: done (90 deg, 1.0 s)", "1 x = 300 mm");
    }

    @Test
    void aPipedWaitDelaysTheNextLines() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300", "wait", "2 move 30", "2 wait", "lab"))
                .containsExactly(
                        "1 move 300: done (300 mm, 1.0 s)",
                        "2 move 30: done (30 mm, 0.1 s)",
                        "lab: aibo x=1234 y=0 heading=0.0 bumps=2");
    }

    @Test
    void withoutAWaitTheShorterAnswersFirst() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300", "2 move 30"))
                .containsExactly("2 move 30: done (30 mm, 0.1 s)", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aPauseLetsTimePass() throws InterruptedException {
        long began = fixture.time.nanos();
        fixture.runPipe("wait 1500ms");
        assertThat(fixture.time.secondsSince(began)).isEqualTo(1.5);
    }

    @Test
    void atAPromptGetReadsAtOnce() throws InterruptedException {
        fixture.prompt.parseText("1 move 300");
        fixture.prompt.parseText("1 get x");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers()).containsExactly("1 x = 0 mm", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void inAPipeGetNowReadsAtOnce() throws InterruptedException {
        assertThat(fixture.runPipe("1 move 300", "1 get now x"))
                .containsExactly("1 x = 0 mm", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aTypedWaitDelaysCommandsButNotReadings() throws InterruptedException {
        fixture.prompt.parseText("1 move 300");
        fixture.prompt.parseText("wait");
        assertThat(fixture.prompt.parseText("2 move 30")).isEmpty();
        fixture.prompt.parseText("bots");
        fixture.prompt.parseText("1 get voltage");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers())
                .containsExactly(
                        "1: Aibo connected, busy",
                        "2: Pioneer connected, idle",
                        "1 voltage = 12.6 V",
                        "1 move 300: done (300 mm, 1.0 s)",
                        "2 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void quitDoesNotWaitAtAPrompt() {
        fixture.prompt.parseText("1 move 300");
        fixture.prompt.parseText("wait");
        fixture.prompt.parseText("quit");
        assertThat(fixture.quits).hasValue(1);
    }

    @Test
    void whileLetsTheRobotsItReadsFinishFirst() throws InterruptedException {
        fixture.bot(1).putObstacle(1000);
        fixture.runPipe("while 1 distanceFront > 400", "1 move 300", "end");
        assertThat(fixture.bot(1).sent()).containsExactly("move 300", "move 300");
    }

    @Test
    void aTypedLineIsRefusedByAFullQueueAndAPipedOneWaits() throws InterruptedException {
        for (int line = 0; line <= 100; line++) {
            assertThat(fixture.prompt.parseText("1 move 30")).isEmpty();
            fixture.pause(line == 0 ? 0.01 : 0);
        }
        assertThat(fixture.prompt.parseText("1 move 30").orElse("")).contains("its queue is full (100 commands)");
        assertThat(fixture.pipe.parseText("1 move 60")).isEmpty();
        fixture.pipe.awaitAll();
        assertThat(fixture.bot(1).sent()).hasSize(102).endsWith("move 60");
    }

    @Test
    void aRobotAddedInAPipeCanBeCommandedInTheNextLine() throws InterruptedException {
        assertThat(fixture.runPipe("add sim:aibo as 5", "5 move 30", "wait", "remove 5", "bots"))
                .containsExactly(
                        "5: Aibo at sim:aibo connected",
                        "5 move 30: done (30 mm, 0.1 s)",
                        "Bot 5 is dead",
                        "1: Aibo connected, idle",
                        "2: Pioneer connected, idle");
    }

    @Test
    void robotsAddedAtAPromptGetTheirNumbersInOrder() throws InterruptedException {
        fixture.aibo.prepare(bot -> bot.connectIn(2));
        fixture.prompt.parseText("add sim:aibo");
        fixture.prompt.parseText("add sim:pioneer");
        fixture.prompt.awaitAll();
        assertThat(fixture.answers())
                .containsExactly("3: Aibo at sim:aibo connected", "4: Pioneer at sim:pioneer connected");
    }
}
