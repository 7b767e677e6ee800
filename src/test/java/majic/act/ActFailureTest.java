package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.time.Signal;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how the errors of an act are reported, and that they leave its robots stopped and free. */
@Tag("jdk")
class ActFailureTest {
    @AutoClose
    private final TwoRobots rig = new TwoRobots();

    @Test
    void aMistakeOfItsAuthorIsToldWithItsPlace() throws InterruptedException {
        rig.submit(rig.alone(new MajicAct() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                throw new IllegalStateException("no idea");
            }
        }));
        rig.awaitIdle();
        assertThat(rig.said)
                .anyMatch(line -> line.matches(
                        "1 act: failed: IllegalStateException: no idea \\(ActFailureTest.java, line \\d+\\)"));
    }

    /** Fails with its first note, and again in its clean-up. */
    private static final class Failing extends MajicAct {
        private static final long serialVersionUID = 1;

        private final String first;

        private Failing(String first) {
            this.first = first;
        }

        @Override
        protected void behave() {
            if (first.equals("undeclared")) {
                throwAnything(new java.io.IOException("undeclared"));
            }
            if (!first.isEmpty()) {
                throw new IllegalStateException(first);
            }
        }

        @Override
        protected void ended(boolean cutShort) {
            throw new IllegalArgumentException("second");
        }

        @SuppressWarnings("unchecked")
        private static <T extends Throwable> void throwAnything(Throwable thrown) throws T {
            throw (T) thrown;
        }
    }

    @ParameterizedTest
    @CsvSource({
        "no idea, 'IllegalStateException: no idea .*; then its ended\\(\\) failed: IllegalArgumentException: second .*'",
        "undeclared, 'IOException: undeclared .*; then its ended\\(\\) failed: IllegalArgumentException: second .*'",
        "'', 'its ended\\(\\) failed: IllegalArgumentException: second .*'"
    })
    void allThatFailedIsToldWithTheFirstReasonFirst(String first, String why) throws InterruptedException {
        rig.submit(rig.alone(new Failing(first)));
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.matches("1 act: failed: " + why));
        assertThat(rig.leader.sent()).endsWith("halt");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void anErrorInItsCodeLeavesItsRobotStoppedAndFree(boolean inItsEnding) throws InterruptedException {
        rig.submit(rig.alone(new MajicAct() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                bot.drive(100, 0);
                if (!inItsEnding) {
                    endless(0);
                }
            }

            @Override
            protected void ended(boolean cutShort) {
                endless(0);
            }

            private int endless(int depth) {
                return endless(depth + 1) + 1;
            }
        }));
        rig.awaitIdle();
        assertThat(rig.said)
                .anyMatch(line -> line.startsWith("1 act: failed: ") && line.contains("StackOverflowError"));
        assertThat(rig.leader.sent()).containsSubsequence("drive 100 0", "halt");
        assertThat(rig.first.owner()).isNull();
    }

    /** A clock with which an act's thread cannot be registered. */
    private record ClosedToActs(TimeSource time) implements TimeSource {
        @Override
        public long nanos() {
            return time.nanos();
        }

        @Override
        public Signal signal() {
            return time.signal();
        }

        @Override
        public Thread thread(String name, Runnable body) {
            return time.thread(name, body);
        }

        @Override
        public Membership join() {
            if (Thread.currentThread() instanceof MajicAct) {
                throw new OutOfMemoryError("no room");
            }
            return time.join();
        }
    }

    @Test
    void anActThatCannotEnterItsClockLeavesItsRobotFree() throws InterruptedException {
        FakeBot robot = FakeBot.on(new ClosedToActs(rig.time));
        robot.connect();
        Member third = rig.team.add(robot, OptionalInt.empty());
        ActRun run = new ActRun(new TwoRobots.Pair(), "Alone", Map.of(Role.ME, List.of(third)), third.currentPermit());
        third.submit(
                new QueuedCommand("act", true, control -> {
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
        assertThat(rig.team.changes().await(third::isIdle, Signal.FOR_EVER)).isTrue();
        assertThat(rig.said).anyMatch(line -> line.startsWith("3 act: failed: OutOfMemoryError: no room"));
        assertThat(third.owner()).isNull();
    }
}
