package majic.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.bot.FakeBot;
import majic.bot.MajicBot.Connection;
import majic.drivertest.TestClock;
import majic.team.AutoReconnect.Status;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class AutoReconnectTest {
    private static final BotException ABSENT = new BotException("nothing answers");

    private final TestClock clock = new TestClock();
    private final Team team = new Team(clock.time());
    private final List<Optional<Status>> shown = Collections.synchronizedList(new ArrayList<>());
    private final AutoReconnect reconnect = new AutoReconnect(team, this::changed);
    private final FakeBot bot = FakeBot.on(clock.time());

    private void changed(Member member) {
        shown.add(reconnect.status(member));
    }

    @BeforeEach
    void add() {
        bot.connect();
        team.add(bot, OptionalInt.empty());
        reconnect.enable(true);
    }

    @AfterEach
    void close() {
        reconnect.close();
        team.close();
        clock.close();
    }

    private Member member() {
        return team.member(1);
    }

    private void let(double seconds) throws InterruptedException {
        clock.time().sleep(seconds);
    }

    @Test
    void aLostRobotIsConnectedAgainAfterOneSecond() throws InterruptedException {
        bot.cut();
        let(0.9);
        assertThat(reconnect.status(member())).contains(new Status(false, 1));
        assertThat(bot.connection()).isEqualTo(Connection.LOST);

        let(0.2);
        assertThat(bot.isConnected()).isTrue();
        assertThat(reconnect.status(member())).isEmpty();
    }

    @Test
    void theDelaysGrowToHalfAMinute() throws InterruptedException {
        bot.refuse(ABSENT);
        bot.cut();
        let(1 + 2 + 5 + 10 + 20 + 30 + 30 + 0.5);

        List<Integer> delays = new ArrayList<>();
        for (int index = 0; index < shown.size(); index++) {
            boolean first = index == 0 || shown.get(index - 1).orElseThrow().connecting();
            if (first) {
                delays.add(shown.get(index).orElseThrow().seconds());
            }
        }
        assertThat(delays).containsExactly(1, 2, 5, 10, 20, 30, 30, 30);
    }

    @Test
    void theCountdownIsShownEverySecond() throws InterruptedException {
        bot.refuse(ABSENT);
        bot.cut();
        let(3.5);

        assertThat(shown)
                .extracting(Optional::orElseThrow)
                .containsExactly(
                        new Status(false, 1),
                        new Status(true, 0),
                        new Status(false, 2),
                        new Status(false, 1),
                        new Status(true, 0),
                        new Status(false, 5));
    }

    @Test
    void aCancelledRobotStaysLostUntilItIsConnectedByHand() throws InterruptedException {
        bot.cut();
        reconnect.cancel(member());
        let(100);
        assertThat(bot.connection()).isEqualTo(Connection.LOST);
        assertThat(reconnect.status(member())).isEmpty();

        bot.connect();
        let(40);
        bot.cut();
        let(1.1);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aConnectionMadeByHandEndsTheCountdown() throws InterruptedException {
        bot.refuse(ABSENT);
        bot.cut();
        let(4);
        bot.breakDownWhileConnecting(null);
        bot.connect();
        let(1);

        assertThat(reconnect.status(member())).isEmpty();
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void aRobotThatAUserTriesToConnectFirstIsConnectedAgain() throws InterruptedException {
        reconnect.close();
        team.addListener(new TeamListener() {
            @Override
            public void lost(Member member, String reason) {
                clock.time().runAsync("a user", () -> catchThrowable(bot::connect));
                while (bot.connection() != Connection.CONNECTING) {
                    Thread.onSpinWait();
                }
            }
        });
        try (AutoReconnect behind = new AutoReconnect(team, member -> {})) {
            behind.enable(true);
            bot.connectIn(0.5);
            bot.refuse(ABSENT);
            bot.cut();
            let(0.8);
            bot.breakDownWhileConnecting(null);
            let(2);

            assertThat(bot.isConnected()).isTrue();
        }
    }

    @Test
    void aConnectionThatIsLostAgainAtOnceDoesNotBeginTheDelaysAgain() throws InterruptedException {
        bot.cut();
        let(1.1);
        bot.cut();
        let(0.1);

        assertThat(reconnect.status(member())).contains(new Status(false, 2));
    }

    @Test
    void aConnectionThatLastedBeginsTheDelaysAgain() throws InterruptedException {
        bot.cut();
        let(40);
        bot.cut();
        let(0.1);

        assertThat(reconnect.status(member())).contains(new Status(false, 1));
    }

    @Test
    void nothingThatWasQueuedOrMovingResumes() throws InterruptedException {
        member().submit(new QueuedCommand("move", true, robot -> List.of("moved " + robot.move(5000))), null);
        member().submit(new QueuedCommand("move", true, robot -> List.of("moved " + robot.move(100))), null);
        let(0.5);
        bot.cut();
        let(10);

        assertThat(bot.isConnected()).isTrue();
        assertThat(bot.isBusy()).isFalse();
        assertThat(bot.sent()).containsOnlyOnce("move 5000").doesNotContain("move 100");
    }

    @Test
    void stopStaysLatched() throws InterruptedException {
        team.stopAll();
        bot.cut();
        let(2);

        assertThat(bot.isConnected()).isTrue();
        assertThat(team.isLatched()).isTrue();
        assertThat(bot.sent()).noneMatch(sent -> sent.startsWith("move"));
        assertThatThrownBy(() -> bot.move(10)).hasMessageContaining("STOP is latched");
    }

    @Test
    void aRemovedRobotIsNotTriedAnyMore() throws InterruptedException {
        bot.refuse(ABSENT);
        bot.cut();
        let(0.5);
        Member removed = member();
        team.remove(1);
        let(5);

        assertThat(reconnect.status(removed)).isEmpty();
        assertThat(bot.connection()).isEqualTo(Connection.CLOSED);
    }

    @Test
    void whileSwitchedOffLostRobotsStayLost() throws InterruptedException {
        reconnect.enable(false);
        bot.cut();
        let(10);
        assertThat(bot.connection()).isEqualTo(Connection.LOST);

        reconnect.enable(true);
        let(1.1);
        assertThat(bot.isConnected()).isTrue();
    }

    @Test
    void anotherDeviceInItsPlaceIsReportedOnce() throws InterruptedException {
        List<String> notices = Collections.synchronizedList(new ArrayList<>());
        team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String message) {
                notices.add(message);
            }
        });
        bot.refuse(new ConnectFailed(ConnectFailed.Reason.OTHER_ADAPTER, "another adapter has its name now"));

        bot.cut();
        let(20);

        assertThat(notices).containsExactly("1: not connected again: another adapter has its name now");
        assertThat(reconnect.status(member())).isPresent();
    }
}
