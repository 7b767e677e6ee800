package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.time.Signal;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests that a stop or a loss of one of its robots ends an act for all of them. */
@Tag("jdk")
class ActStopTest {
    @AutoClose
    private final TwoRobots rig = new TwoRobots();

    @Test
    void aStopOfOneOfItsRobotsEndsItForAll() throws InterruptedException {
        rig.submit(rig.pair());
        rig.time.sleep(5);
        rig.team.stop(List.of(rig.second), null);
        rig.awaitIdle();
        rig.team.changes().await(rig.team::areStopsAnswered, Signal.FOR_EVER);
        assertThat(rig.said).contains("1 act: stopped", "2 stop: done");
        assertThat(List.of(rig.first, rig.second)).allMatch(member -> member.owner() == null);
        assertThat(rig.leader.sent()).endsWith("halt");
    }

    @Test
    void calledOffItIsNotAComplaint() throws InterruptedException {
        ActRun run = rig.pair();
        rig.submit(run);
        rig.time.sleep(5);
        run.callOff();
        rig.awaitIdle();
        assertThat(rig.said).contains("1 act: done").noneMatch(line -> line.contains("stopped"));
    }

    @Test
    void whatWasStoppedBeforeItBeganDoesNotBegin() throws InterruptedException {
        ActRun run = rig.pair();
        rig.first.submit(
                new QueuedCommand("act", true, robot -> {
                    rig.team.stop(List.of(rig.second), null);
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
        rig.awaitIdle();
        assertThat(rig.said).contains("1 act: stopped").doesNotContain("1: Pair: off we go");
        assertThat(rig.leader.sent()).isEmpty();
    }

    @Test
    void aDriverThatBreaksDownHoldsUpNoEnd() throws InterruptedException {
        rig.follower.breakDownWhenHalted();
        rig.submit(rig.pair());
        rig.time.sleep(5);
        rig.team.stop(List.of(rig.first), null);
        rig.awaitIdle();
        assertThat(rig.said).contains("1 act: stopped");
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
            others.addListener(rig);
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
            assertThat(rig.said).contains("1: Deaf: does not end; it is left behind without a robot", "1 act: stopped");
            deaf.over.countDown();
        }
    }

    @Test
    void aRobotLostUnderWayIsWhyItFails() throws InterruptedException {
        rig.submit(rig.pair());
        rig.time.sleep(0.1);
        rig.follower.cut();
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.startsWith("1 act: failed: connection lost"));
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
        rig.submit(rig.both(new Stubborn()));
        rig.time.sleep(0.1);
        rig.follower.cut();
        rig.follower.connect();
        rig.awaitIdle();
        assertThat(rig.said).anyMatch(line -> line.startsWith("1 act: failed: connection lost"));
        assertThat(rig.leader.sent()).startsWith("move 100", "halt").containsOnlyOnce("move 100");
        assertThat(rig.leader.isConnected()).isTrue();
        assertThat(rig.follower.sent()).doesNotContain("move 100");
    }
}
