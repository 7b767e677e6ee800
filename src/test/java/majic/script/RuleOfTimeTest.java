package majic.script;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Commands to one robot run in order, different robots run side by side, a wait joins them. */
@Timeout(30)
class RuleOfTimeTest {
    @AutoClose
    private final Desk desk = Desk.withTwo();

    @Test
    void linesToOneRobotFollowEachOther() throws InterruptedException {
        assertThat(desk.runPipe("1 move 300", "1 turn 90", "1 get x"))
                .containsExactly("1 move 300: done (300 mm, 1.0 s)", "1 turn 90: done (90 deg, 1.0 s)", "1 x = 300 mm");
    }

    @Test
    void aPipedWaitHoldsTheNextLines() throws InterruptedException {
        assertThat(desk.runPipe("1 move 300", "wait", "2 move 30", "2 wait", "lab"))
                .containsExactly(
                        "1 move 300: done (300 mm, 1.0 s)",
                        "2 move 30: done (30 mm, 0.1 s)",
                        "lab: aibo x=1234 y=0 heading=0.0");
    }

    @Test
    void withoutAWaitTheShorterAnswersFirst() throws InterruptedException {
        assertThat(desk.runPipe("1 move 300", "2 move 30"))
                .containsExactly("2 move 30: done (30 mm, 0.1 s)", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aPauseLetsTimePass() throws InterruptedException {
        long began = desk.time.nanos();
        desk.runPipe("wait 1500ms");
        assertThat(desk.time.secondsSince(began)).isEqualTo(1.5);
    }

    @Test
    void atAPromptGetReadsAtOnce() throws InterruptedException {
        desk.prompt.parseText("1 move 300");
        desk.prompt.parseText("1 get x");
        desk.prompt.awaitAll();
        assertThat(desk.said()).containsExactly("1 x = 0 mm", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void inAPipeGetNowReadsAtOnce() throws InterruptedException {
        assertThat(desk.runPipe("1 move 300", "1 get now x"))
                .containsExactly("1 x = 0 mm", "1 move 300: done (300 mm, 1.0 s)");
    }

    @Test
    void aTypedWaitHoldsLinesButNotReadings() throws InterruptedException {
        desk.prompt.parseText("1 move 300");
        desk.prompt.parseText("wait");
        assertThat(desk.prompt.parseText("2 move 30")).isEmpty();
        desk.prompt.parseText("bots");
        desk.prompt.parseText("1 get voltage");
        desk.prompt.awaitAll();
        assertThat(desk.said())
                .containsExactly(
                        "1: Aibo connected, busy",
                        "2: Pioneer connected, idle",
                        "1 voltage = 12.6 V",
                        "1 move 300: done (300 mm, 1.0 s)",
                        "2 move 30: done (30 mm, 0.1 s)");
    }

    @Test
    void quitDoesNotWaitAtAPrompt() {
        desk.prompt.parseText("1 move 300");
        desk.prompt.parseText("wait");
        desk.prompt.parseText("quit");
        assertThat(desk.quits).hasValue(1);
    }

    @Test
    void whileLetsTheRobotsItReadsFinishFirst() throws InterruptedException {
        desk.bot(1).putObstacle(1000);
        desk.runPipe("while 1 distanceFront > 400", "1 move 300", "end");
        assertThat(desk.bot(1).sent()).containsExactly("move 300", "move 300");
    }

    @Test
    void aTypedLineIsRefusedByAFullQueueAndAPipedOneWaits() throws InterruptedException {
        for (int line = 0; line <= 100; line++) {
            assertThat(desk.prompt.parseText("1 move 30")).isEmpty();
            desk.pause(line == 0 ? 0.01 : 0);
        }
        assertThat(desk.prompt.parseText("1 move 30").orElse("")).contains("its queue is full (100 commands)");
        assertThat(desk.pipe.parseText("1 move 60")).isEmpty();
        desk.pipe.awaitAll();
        assertThat(desk.bot(1).sent()).hasSize(102).endsWith("move 60");
    }

    @Test
    void aRobotAddedInAPipeCanBeCommandedInTheNextLine() throws InterruptedException {
        assertThat(desk.runPipe("add sim:aibo as 5", "5 move 30", "wait", "remove 5", "bots"))
                .containsExactly(
                        "5: Aibo at sim:aibo connected",
                        "5 move 30: done (30 mm, 0.1 s)",
                        "Bot 5 is dead",
                        "1: Aibo connected, idle",
                        "2: Pioneer connected, idle");
    }

    @Test
    void robotsAddedByHandGetTheirNumbersInOrder() throws InterruptedException {
        desk.aibo.prepare(bot -> bot.connectIn(2));
        desk.prompt.parseText("add sim:aibo");
        desk.prompt.parseText("add sim:pioneer");
        desk.prompt.awaitAll();
        assertThat(desk.said()).containsExactly("3: Aibo at sim:aibo connected", "4: Pioneer at sim:pioneer connected");
    }
}
