package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotControl;
import majic.bot.FakeBot;
import majic.bot.MotionStopped;
import majic.drivertest.TestClock;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests that an act can command its robot until it ends, and never afterwards. */
class MajicActTest {
    private static final List<String> SAID = new CopyOnWriteArrayList<>();

    private final TestClock clock = new TestClock();
    private final TimeSource time = clock.time();
    private final Team team = new Team(time);
    private final FakeBot robot = FakeBot.on(time);
    private Member member;

    @BeforeEach
    void connect() {
        SAID.clear();
        robot.connect();
        member = team.add(robot, OptionalInt.empty());
    }

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    /** Returns the message of the exception. */
    private static String reason(Runnable refused) {
        try {
            refused.run();
            return "none";
        } catch (MotionStopped e) {
            return e.getMessage();
        }
    }

    /** Leaves a thread behind that drives its robot and pauses. */
    private static final class Leaving extends MajicAct {
        private static final long serialVersionUID = 1;

        private final transient CountDownLatch over = new CountDownLatch(1);
        private final transient CountDownLatch told = new CountDownLatch(1);

        @Override
        protected void behave() {
            new Thread(this::driveOn).start();
        }

        private void driveOn() {
            try {
                over.await();
                SAID.add("first: " + reason(() -> bot.move(100)));
                SAID.add("second: " + reason(() -> bot.drive(100, 0)));
                SAID.add("pause: " + reason(() -> pause(1)));
            } catch (InterruptedException e) {
                SAID.add("interrupted");
            } finally {
                told.countDown();
            }
        }
    }

    @Test
    void aThreadThatItLeavesBehindIsRefusedEachTimeInTheSameWay() throws InterruptedException {
        Leaving act = new Leaving();
        act.start(robot);
        act.join();
        act.over.countDown();
        act.told.await();
        assertThat(SAID)
                .containsExactly("first: the act has ended", "second: the act has ended", "pause: the act was ended");
        assertThat(robot.sent()).doesNotContain("move 100");
    }

    @Test
    void itIsNotStartedAsAThread() {
        assertThatThrownBy(() -> new Square(1).start())
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("an act is started with its robot");
    }

    /** Drives a square, and tries to repeat its first side after it was ended. */
    private static final class Square extends MajicAct {
        private static final long serialVersionUID = 1;

        private final int sides;

        Square(int sides) {
            this.sides = sides;
        }

        @Override
        protected void behave() {
            BotControl mine = bot;
            try {
                for (int side = 0; side < sides; side++) {
                    mine.move(300);
                    pause(2);
                    mine.turn(90);
                }
            } catch (MotionStopped e) {
                mine.move(300);
            }
        }

        @Override
        protected void ended(boolean cutShort) {
            SAID.add("cut short: " + cutShort + ", robot: " + reason(() -> bot.move(100)));
        }
    }

    @Test
    void commandsItsRobotAndPausesOnItsClock() throws InterruptedException {
        MajicAct square = new Square(2);
        square.start(robot);
        time.sleep(8.5);
        square.join();
        assertThat(robot.sent()).startsWith("move 300", "turn 90", "move 300", "turn 90");
        assertThat(SAID).containsExactly("cut short: false, robot: the act has ended");
    }

    @Test
    void endedWhileItMovesItHaltsTheRobotAndLosesIt() throws InterruptedException {
        MajicAct square = new Square(4);
        square.start(robot);
        time.sleep(0.5);
        square.end();
        square.join();
        assertThat(robot.sent()).startsWith("move 300", "halt").containsOnlyOnce("move 300");
        assertThat(SAID).containsExactly("cut short: true, robot: the act has ended");
    }

    @Test
    void endedWhileItPausesItWakesAtOnce() throws InterruptedException {
        MajicAct square = new Square(4);
        square.start(robot);
        time.sleep(2);
        square.end();
        square.join();
        assertThat(robot.sent()).containsOnlyOnce("move 300").doesNotContain("turn 90");
    }

    @Test
    void keptControlsAreOfNoUseAfterwards() throws InterruptedException {
        Thief thief = new Thief();
        thief.start(robot);
        thief.join();
        assertThatThrownBy(() -> thief.kept.move(100)).isInstanceOf(MotionStopped.class);
        assertThatThrownBy(() -> thief.kept.get("x")).isInstanceOf(MotionStopped.class);
    }

    private static final class Thief extends MajicAct {
        private static final long serialVersionUID = 1;

        private transient BotControl kept;

        @Override
        protected void behave() {
            kept = bot;
            throw new IllegalStateException("a mistake of the author");
        }
    }

    @Test
    void runsOnlyOnce() throws InterruptedException {
        MajicAct square = new Square(0);
        square.start(robot);
        square.join();
        assertThatThrownBy(() -> square.start(robot)).isInstanceOf(IllegalThreadStateException.class);
    }

    @Test
    void savedAndReadBackItIsFreshAndRuns() throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(new Square(1));
        }
        MajicAct again;
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
            again = (MajicAct) in.readObject();
        }
        again.start(robot);
        time.sleep(5);
        again.join();
        assertThat(robot.sent()).startsWith("move 300", "turn 90");
    }

    @Test
    void endedBeforeItIsStartedItDoesNothing() throws InterruptedException {
        MajicAct square = new Square(4);
        square.end();
        square.start(robot);
        square.join();
        assertThat(robot.sent()).doesNotContain("move 300");
        assertThat(SAID).containsExactly("cut short: true, robot: the act has ended");
    }

    /** Swallows an interrupt, as many libraries do. */
    private static final class Swallowing extends MajicAct {
        private static final long serialVersionUID = 1;

        private final transient CountDownLatch begun = new CountDownLatch(1);

        @Override
        protected void behave() {
            try {
                begun.countDown();
                new CountDownLatch(1).await();
            } catch (InterruptedException e) {
                SAID.add("woken");
            }
            pause(0);
            SAID.add("went on");
        }
    }

    @Test
    void itsNextPauseEndsOneThatSwallowedTheInterrupt() throws InterruptedException {
        Swallowing act = new Swallowing();
        act.start(robot);
        act.begun.await();
        act.end();
        act.join();
        assertThat(SAID).containsExactly("woken");
    }
}
