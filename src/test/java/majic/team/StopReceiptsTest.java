package majic.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;
import majic.bot.FakeBot;
import majic.drivertest.TestClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests what the team reports about the confirmation of stops. */
class StopReceiptsTest {
    private static final String STUCK = "takes no more data";
    private static final String OVERDUE = "not confirmed within 0.8 s";

    private final TestClock clock = new TestClock();

    private final Team team = new Team(clock.time());

    private final List<StopStatus> reported = Collections.synchronizedList(new ArrayList<>());
    private final FakeBot first = FakeBot.on(clock.time());
    private final FakeBot second = FakeBot.on(clock.time());

    @BeforeEach
    void connect() {
        for (FakeBot bot : List.of(first, second)) {
            bot.connect();
            team.add(bot, OptionalInt.empty());
        }
        team.addListener(new TeamListener() {
            @Override
            public void stopStatusChanged(StopStatus status) {
                reported.add(status);
            }
        });
    }

    @AfterEach
    void close() {
        team.close();
        clock.close();
    }

    private void awaitStatus(int asked, int confirmed, Map<Integer, String> unconfirmed) throws InterruptedException {
        StopStatus wanted = new StopStatus(asked, confirmed, new TreeMap<>(unconfirmed), "");
        team.changes().await(() -> team.stopStatus().equals(wanted), 100);
        assertThat(team.stopStatus()).isEqualTo(wanted);
    }

    @Test
    void aTeamThatWasNotStoppedHasNothingToConfirm() {
        assertThat(team.stopStatus()).isEqualTo(StopStatus.NONE);
    }

    @Test
    void everyRobotThatConfirmsStopIsCounted() throws InterruptedException {
        team.stopAll();

        awaitStatus(2, 2, Map.of());
    }

    @Test
    void aRobotThatHasNotConfirmedYetIsNotCounted() throws InterruptedException {
        second.standAfter(1);
        team.stopAll();

        awaitStatus(2, 1, Map.of());
        awaitStatus(2, 2, Map.of());
    }

    @Test
    void aRobotThatHasNotConfirmedInTimeIsNamedUntilItConfirms() throws InterruptedException {
        List<Integer> overdue = Collections.synchronizedList(new ArrayList<>());
        team.addListener(new TeamListener() {
            @Override
            public void stopOverdue(Collection<Member> members, double seconds) {
                members.forEach(member -> overdue.add(member.number()));
            }
        });
        second.standAfter(2);
        team.stopAll();

        awaitStatus(2, 1, Map.of(2, OVERDUE));
        awaitStatus(2, 2, Map.of());
        assertThat(overdue).containsExactly(2);
    }

    @Test
    void aRobotThatReportsThatItSlowsDownIsNotNamedYet() throws InterruptedException {
        second.reportSpeed(300);
        second.standAfter(2);
        second.whenStoppedAhead(() -> second.reportSpeed(200));
        team.stopAll();

        awaitStatus(2, 2, Map.of());
        assertThat(reported).allMatch(status -> status.unconfirmed().isEmpty());
    }

    @Test
    void aRobotThatDoesNotConfirmStopIsNamedWithTheReason() throws InterruptedException {
        second.getStuck();
        team.stopAll();

        awaitStatus(2, 1, Map.of(2, STUCK));
        assertThat(team.stopStatus().problem(2)).contains(STUCK);
        assertThat(team.stopStatus().problem(1)).isEmpty();
    }

    @Test
    void aRobotThatDoesNotConfirmItsOwnStopIsNamedToo() throws InterruptedException {
        second.getStuck();
        team.stop(List.of(team.member(2)), null);

        awaitStatus(0, 0, Map.of(2, STUCK));
    }

    @Test
    void releaseKeepsTheRobotsThatHaveNotConfirmed() throws InterruptedException {
        second.getStuck();
        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));

        team.release();

        awaitStatus(0, 0, Map.of(2, STUCK));
    }

    @Test
    void aRobotThatConfirmsALaterStopIsNotNamedAnyMore() throws InterruptedException {
        second.getStuck();
        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));
        second.comeLoose();

        team.stop(List.of(team.member(2)), null);

        awaitStatus(2, 2, Map.of());
    }

    @Test
    void aRobotIsNamedUntilTheLaterStopIsConfirmed() throws InterruptedException {
        second.getStuck();
        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));
        second.comeLoose();
        second.standAfter(1);

        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));

        awaitStatus(2, 2, Map.of());
    }

    @Test
    void aRemovedRobotIsNotNamedAnyMore() throws InterruptedException {
        second.getStuck();
        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));

        team.remove(2);

        awaitStatus(1, 1, Map.of());
    }

    @Test
    void listenersReceiveEachStateInItsOrder() throws InterruptedException {
        second.getStuck();
        second.standAfter(1);
        team.stopAll();
        awaitStatus(2, 1, Map.of(2, STUCK));
        team.changes().await(() -> team.members().stream().allMatch(Member::isIdle), 100);
        team.release();

        assertThat(reported)
                .containsExactly(
                        new StopStatus(2, 0, new TreeMap<>(), ""),
                        new StopStatus(2, 1, new TreeMap<>(), ""),
                        new StopStatus(2, 1, new TreeMap<>(Map.of(2, OVERDUE)), ""),
                        new StopStatus(2, 1, new TreeMap<>(Map.of(2, STUCK)), ""),
                        new StopStatus(0, 0, new TreeMap<>(Map.of(2, STUCK)), ""));
    }
}
