package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.drivertest.TestClock;
import majic.team.Answer;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.team.TeamListener;
import majic.time.Signal;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that an act has exclusive use of its robots, and that a stop of one of them ends it for all. */
@Tag("jdk")
class ActRunTest implements TeamListener {
    private final TestClock clock = new TestClock();
    private final TimeSource time = clock.time();
    private final Team team = new Team(time);
    private final FakeBot leader = FakeBot.on(time);
    private final FakeBot follower = FakeBot.on(time);
    private final List<String> said = new CopyOnWriteArrayList<>();
    private Member first;
    private Member second;

    @BeforeEach
    void connect() {
        leader.connect();
        follower.connect();
        first = team.add(leader, OptionalInt.empty());
        second = team.add(follower, OptionalInt.empty());
        team.addListener(this);
    }

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    @Override
    public void answered(Answer answer) {
        said.add(answer.text());
    }

    @Override
    public void noticed(int robot, String message) {
        said.add(message);
    }

    /** Drives two robots side by side until it is ended. */
    private static class Pair extends MajicAct {
        private static final long serialVersionUID = 1;

        @Override
        public List<Role> roles() {
            return List.of(Role.any(Role.ME), Role.any("second"));
        }

        @Override
        protected void behave() {
            say("off we go");
            while (true) {
                bot.move(100);
                robot("second").move(200);
            }
        }
    }

    private void submit(ActRun run) {
        first.submit(
                new QueuedCommand("act", true, robot -> {
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
    }

    private ActRun pair() {
        return both(new Pair());
    }

    private ActRun both(MajicAct act) {
        Map<String, List<Member>> cast = new LinkedHashMap<>();
        cast.put(Role.ME, List.of(first));
        cast.put("second", List.of(second));
        return new ActRun(act, "Pair", cast, first.currentPermit().and(second.currentPermit()));
    }

    /** Moves all followers away. */
    private static final class Scatter extends MajicAct {
        private static final long serialVersionUID = 1;

        @Override
        public List<Role> roles() {
            return List.of(Role.any(Role.ME), Role.any("follower").orMore());
        }

        @Override
        protected void behave() {
            robots("follower").forEach(robot -> robot.move(300));
        }
    }

    @Test
    void severalRobotsPlayARoleThatTakesMore() throws InterruptedException {
        FakeBot last = FakeBot.on(time);
        last.connect();
        Member third = team.add(last, OptionalInt.empty());
        Map<String, List<Member>> cast = new LinkedHashMap<>();
        cast.put(Role.ME, List.of(first));
        cast.put("follower", List.of(second, third));
        submit(new ActRun(new Scatter(), "Scatter", cast, first.currentPermit()));
        awaitIdle();
        assertThat(List.of(follower, last))
                .allSatisfy(robot -> assertThat(robot.sent()).startsWith("move 300"));
        assertThat(said).contains("1 act: done");
    }

    private ActRun alone(MajicAct act) {
        return new ActRun(act, "Alone", Map.of(Role.ME, List.of(first)), first.currentPermit());
    }

    private void awaitIdle() throws InterruptedException {
        assertThat(team.changes().await(() -> first.isIdle() && second.isIdle(), 100))
                .isTrue();
    }

    @Test
    void nobodyElseMovesItsRobotsMeanwhile() throws InterruptedException {
        submit(pair());
        time.sleep(1);
        QueuedCommand move = new QueuedCommand("move 1", true, robot -> List.of());
        assertThatThrownBy(() -> second.submit(move, null))
                .hasMessageContaining("2 is running Pair; \"2 stop\" ends it");
        assertThat(said).contains("1: Pair: off we go");
    }

    @Test
    void aStopOfOneOfItsRobotsEndsItForAll() throws InterruptedException {
        submit(pair());
        time.sleep(5);
        team.stop(List.of(second), null);
        awaitIdle();
        team.changes().await(team::areStopsAnswered, Signal.FOR_EVER);
        assertThat(said).contains("1 act: stopped", "2 stop: done");
        assertThat(List.of(first, second)).allMatch(member -> member.owner() == null);
        assertThat(leader.sent()).endsWith("halt");
    }

    @Test
    void calledOffItIsNotAComplaint() throws InterruptedException {
        ActRun run = pair();
        submit(run);
        time.sleep(5);
        run.callOff();
        awaitIdle();
        assertThat(said).contains("1 act: done").noneMatch(line -> line.contains("stopped"));
    }

    @Test
    void aRobotThatIsBusyIsNotTakenAway() throws InterruptedException {
        second.submit(
                new QueuedCommand(
                        "move 1000", true, robot -> List.of(robot.move(1000).toString())),
                null);
        time.sleep(0.1);
        submit(pair());
        time.sleep(1);
        assertThat(said).contains("1 act: failed: 2 is still busy; \"2 wait\" lets it finish first");
    }

    @Test
    void aMistakeOfItsAuthorIsToldWithItsPlace() throws InterruptedException {
        submit(alone(new MajicAct() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                throw new IllegalStateException("no idea");
            }
        }));
        awaitIdle();
        assertThat(said)
                .anyMatch(line ->
                        line.matches("1 act: failed: IllegalStateException: no idea \\(ActRunTest.java, line \\d+\\)"));
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
        submit(alone(new Failing(first)));
        awaitIdle();
        assertThat(said).anyMatch(line -> line.matches("1 act: failed: " + why));
        assertThat(leader.sent()).endsWith("halt");
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
        FakeBot robot = FakeBot.on(new ClosedToActs(time));
        robot.connect();
        Member third = team.add(robot, OptionalInt.empty());
        ActRun run = new ActRun(new Scatter(), "Alone", Map.of(Role.ME, List.of(third)), third.currentPermit());
        third.submit(
                new QueuedCommand("act", true, control -> {
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
        assertThat(team.changes().await(third::isIdle, Signal.FOR_EVER)).isTrue();
        assertThat(said).anyMatch(line -> line.startsWith("3 act: failed: OutOfMemoryError: no room"));
        assertThat(third.owner()).isNull();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void anErrorInItsCodeLeavesItsRobotStoppedAndFree(boolean inItsEnding) throws InterruptedException {
        submit(alone(new MajicAct() {
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
        awaitIdle();
        assertThat(said).anyMatch(line -> line.startsWith("1 act: failed: ") && line.contains("StackOverflowError"));
        assertThat(leader.sent()).containsSubsequence("drive 100 0", "halt");
        assertThat(first.owner()).isNull();
    }

    /** Ignores interrupts until the test is over. */
    private static final class Deaf extends MajicAct {
        private static final long serialVersionUID = 1;

        private final transient CountDownLatch begun = new CountDownLatch(1);
        private final transient CountDownLatch over = new CountDownLatch(1);

        @Override
        protected void behave() {
            begun.countDown();
            boolean waiting = true;
            while (waiting) {
                try {
                    over.await();
                    waiting = false;
                } catch (InterruptedException e) {
                    waiting = true;
                }
            }
        }
    }

    @Test
    void oneThatDoesNotEndIsLeftBehindAndNamed() throws InterruptedException {
        FakeBot robot = FakeBot.on(TimeSource.system());
        robot.connect();
        try (Team others = new Team(TimeSource.system())) {
            others.addListener(this);
            Member member = others.add(robot, OptionalInt.empty());
            Deaf deaf = new Deaf();
            member.submit(
                    new QueuedCommand("act", true, control -> {
                        new ActRun(deaf, "Deaf", Map.of(Role.ME, List.of(member)), member.currentPermit()).run(null);
                        return List.of();
                    }),
                    null);
            deaf.begun.await();
            others.stop(List.of(member), null);
            assertThat(others.changes().await(member::isIdle, 100)).isTrue();
            assertThat(said).contains("1: Deaf: does not end; it is left behind without a robot", "1 act: stopped");
            deaf.over.countDown();
        }
    }

    @Test
    void aRobotLostUnderWayIsWhyItFails() throws InterruptedException {
        submit(pair());
        time.sleep(0.1);
        follower.cut();
        awaitIdle();
        assertThat(said).anyMatch(line -> line.startsWith("1 act: failed: connection lost"));
    }

    /** Continues after every exception, a hundred times. */
    private static final class Stubborn extends MajicAct {
        private static final long serialVersionUID = 1;

        @Override
        public List<Role> roles() {
            return List.of(Role.any(Role.ME), Role.any("second"));
        }

        @Override
        protected void behave() {
            for (int tries = 0; tries < 100; tries++) {
                try {
                    bot.move(100);
                    robot("second").move(100);
                } catch (BotException e) {
                    say("and yet");
                }
            }
        }
    }

    @Test
    void afterALostLinkItResumesNothing() throws InterruptedException {
        submit(both(new Stubborn()));
        time.sleep(0.1);
        follower.cut();
        follower.connect();
        awaitIdle();
        assertThat(said).anyMatch(line -> line.startsWith("1 act: failed: connection lost"));
        assertThat(leader.sent()).startsWith("move 100", "halt").containsOnlyOnce("move 100");
        assertThat(leader.isConnected()).isTrue();
        assertThat(follower.sent()).doesNotContain("move 100");
    }

    @Test
    void whatWasStoppedBeforeItBeganDoesNotBegin() throws InterruptedException {
        ActRun run = pair();
        first.submit(
                new QueuedCommand("act", true, robot -> {
                    team.stop(List.of(second), null);
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
        awaitIdle();
        assertThat(said).contains("1 act: stopped").doesNotContain("1: Pair: off we go");
        assertThat(leader.sent()).isEmpty();
    }

    @Test
    void aDriverThatBreaksDownHoldsUpNoEnd() throws InterruptedException {
        follower.breakDownWhenHalted();
        submit(pair());
        time.sleep(5);
        team.stop(List.of(first), null);
        awaitIdle();
        assertThat(said).contains("1 act: stopped");
    }

    @Test
    void itsOwnStopEndsNoCommandOfAnotherSource() throws InterruptedException {
        Owner script = new Owner(Owner.Kind.SCRIPT, "script", () -> {});
        ActRun run = alone(new MajicAct() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                bot.drive(100, 0);
                bot.stop();
                bot.move(50);
            }
        });
        first.claim(script);
        first.submit(
                new QueuedCommand("act", true, robot -> {
                    run.run(script);
                    return List.of("act: done");
                }),
                script);
        first.submit(new QueuedCommand("turn 90", true, robot -> List.of("turn 90: " + robot.turn(90))), script);
        awaitIdle();
        assertThat(said).anyMatch(line -> line.startsWith("1 turn 90: 90 deg"));
        assertThat(leader.sent()).containsSubsequence("drive 100 0", "halt", "move 50", "turn 90");
    }

    @Test
    void itsRobotsStandBeforeAnybodyElseHasThem() throws InterruptedException {
        leader.standAfter(1);
        follower.standAfter(1);
        submit(both(new Pair() {
            private static final long serialVersionUID = 1;

            @Override
            protected void behave() {
                bot.drive(100, 0);
                interrupt();
            }
        }));
        awaitIdle();
        assertThat(leader.sent()).endsWith("stands");
        assertThat(follower.sent()).endsWith("stands");
    }

    @Test
    void aRobotThatIsJustBeingStoppedIsNotTaken() throws InterruptedException {
        follower.standAfter(1);
        team.stop(List.of(second), null);
        submit(pair());
        time.sleep(0.5);
        assertThat(said).contains("1 act: failed: 2 is still busy; \"2 wait\" lets it finish first");
    }
}
