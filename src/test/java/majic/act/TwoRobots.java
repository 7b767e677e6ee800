package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.FakeBot;
import majic.drivertest.TestClock;
import majic.team.Answer;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.team.TeamListener;
import majic.time.TimeSource;

/** Two robots for acts, on a clock that steps, and what the team reports of them. */
final class TwoRobots implements TeamListener, AutoCloseable {
    private final TestClock clock = new TestClock();
    final TimeSource time = clock.time();
    final Team team = new Team(time);
    final FakeBot leader = FakeBot.on(time);
    final FakeBot follower = FakeBot.on(time);
    final List<String> said = new CopyOnWriteArrayList<>();
    final Member first;
    final Member second;

    TwoRobots() {
        leader.connect();
        follower.connect();
        first = team.add(leader, OptionalInt.empty());
        second = team.add(follower, OptionalInt.empty());
        team.addListener(this);
    }

    /** Drives two robots side by side until it is ended. */
    static class Pair extends MajicAct {
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

    /** Submits an act to the first robot. */
    void submit(ActRun run) {
        first.submit(
                new QueuedCommand("act", true, robot -> {
                    run.run(null);
                    return List.of("act: done");
                }),
                null);
    }

    ActRun pair() {
        return both(new Pair());
    }

    ActRun both(MajicAct act) {
        Map<String, List<Member>> cast = new LinkedHashMap<>();
        cast.put(Role.ME, List.of(first));
        cast.put("second", List.of(second));
        return new ActRun(act, "Pair", cast, first.currentPermit().and(second.currentPermit()));
    }

    ActRun alone(MajicAct act) {
        return new ActRun(act, "Alone", Map.of(Role.ME, List.of(first)), first.currentPermit());
    }

    void awaitIdle() throws InterruptedException {
        assertThat(team.changes().await(() -> first.isIdle() && second.isIdle(), 100))
                .isTrue();
    }

    @Override
    public void answered(Answer answer) {
        said.add(answer.text());
    }

    @Override
    public void noticed(int robot, String message) {
        said.add(message);
    }

    @Override
    public void close() {
        team.close();
        clock.close();
    }
}
