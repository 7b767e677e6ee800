package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import majic.bot.FakeBot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.LatchMessage;
import majic.shared.message.Sender;
import majic.team.StopOrigin;
import majic.team.Team;
import majic.team.TeamListener;
import majic.time.Signal;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the STOP of all desks of a site: two desks that share robots, and a third that only uses them. */
class SiteLatchTest {
    private static final String TOPIC = "lab/majic/1/stop";

    @AutoClose
    private final SharingRig rig = SharingRig.started();

    @AutoClose
    private final Team other = new Team(rig.clock.time());

    private final FakeBot bot = FakeBot.on(rig.clock.time());

    @AutoClose
    private final DeskSharing sharing = rig.sharing("desk3", other);

    private FakeConnection connection;

    @BeforeEach
    void shareTheOtherTeam() {
        bot.connect();
        other.add(bot, OptionalInt.empty());
        sharing.start();
        connection = rig.connections.get(1);
    }

    private void bothLatched(boolean latched) {
        rig.clock.until(() -> rig.team.isLatched() == latched && other.isLatched() == latched);
    }

    private LatchMessage kept() {
        return LatchMessage.parse(rig.broker.retained(TOPIC).orElseThrow().payload());
    }

    @Test
    void stopAtOneDeskStopsAllRobotsOfTheOther() {
        rig.team.stopAll();

        bothLatched(true);
        rig.clock.until(() -> bot.sent().contains("halt"));
        assertThat(kept().latched()).isTrue();
    }

    @Test
    void whoPressedAndWhoReleasedIsTold() {
        other.stopAll();
        bothLatched(true);
        rig.clock.until(() -> rig.isSaid("STOP by Bob at desk3"));

        other.release();

        bothLatched(false);
        rig.clock.until(() -> rig.isSaid("released by Bob at desk3"));
        assertThat(kept().latched()).isFalse();
    }

    @Test
    void anyDeskReleasesTheStopOfAnother() {
        rig.team.stopAll();
        bothLatched(true);
        other.release();

        bothLatched(false);
        rig.sleep(5);
        assertThat(rig.team.isLatched()).isFalse();
    }

    @Test
    @SuppressWarnings("try")
    void aDeskThatJoinsLaterObeysTheStop() {
        rig.team.stopAll();
        bothLatched(true);
        Team late = new Team(rig.clock.time());
        FakeConnection using = open("late");
        using.connect();

        try (SiteLatch latch = new SiteLatch(late, using, "lab", Sender.ofThisRun("late", "Zoe"))) {
            rig.clock.until(late::isLatched);
            late.release();
            bothLatched(false);
        }
        rig.clock.until(() -> rig.isSaid("released by Zoe at late"));
        late.close();
    }

    @Test
    @SuppressWarnings("try")
    void aDeskThatJoinsLaterSaysWhoseStopItObeysAndSinceWhen() {
        Instant pressed = LocalDateTime.of(2026, 1, 5, 14, 2)
                .atZone(ZoneId.systemDefault())
                .toInstant();
        LatchMessage stop = LatchMessage.stop("id-1", new Sender("desk9", "Eve", "s"), pressed);
        rig.broker.publish(
                BrokerMessage.json(TOPIC, stop.toJson(), Quality.AT_LEAST_ONCE).retain());
        bothLatched(true);
        rig.clock.until(() -> rig.isSaid("STOP by Eve at desk9"));
        Team late = new Team(rig.clock.time());
        FakeConnection using = open("late");
        using.connect();

        try (SiteLatch latch = new SiteLatch(late, using, "lab", Sender.ofThisRun("late", "Zoe"))) {
            rig.clock.until(late::isLatched);
            assertThat(late.latchText())
                    .isEqualTo("STOP by Eve at desk9, pressed at 2026-01-05 14:02, is latched;"
                            + " \"release\" allows motion again");
            assertThat(late.stopOrigin()).contains(new StopOrigin("Eve at desk9", pressed));
            late.release();
            bothLatched(false);
            assertThat(late.stopOrigin()).isEmpty();
        }
        late.close();
    }

    @Test
    void aStopThatAnotherDeskPublishesAgainKeepsItsOrigin() {
        other.stopAll();
        bothLatched(true);
        LatchMessage stop = kept();
        rig.broker.stop();
        rig.broker.forget();
        rig.clock.until(() -> !rig.sharing.isConnected() && !sharing.isConnected());
        connection.cut();
        rig.broker.start();

        rig.clock.until(() -> rig.broker.retained(TOPIC).isPresent());
        assertThat(kept()).isEqualTo(stop);
        assertThat(stop.by()).isEqualTo("Bob at desk3");
        assertThat(stop.time()).isNotNull();
        connection.restore();
    }

    /** A listener that blocks keeps the others from events for as long as it likes, but not the site from STOP. */
    @Test
    void aBlockedListenerDelaysNeitherStopNorReleaseOfTheSite() {
        Team slow = new Team(rig.clock.time());
        Signal never = rig.clock.time().signal();
        AtomicBoolean blocked = new AtomicBoolean(true);
        slow.addListener(new TeamListener() {
            @Override
            public void latchChanged(boolean latched) {
                try {
                    never.await(() -> !blocked.get(), Signal.FOR_EVER);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        });
        try (DeskSharing third = rig.sharing("desk4", slow)) {
            third.start();
            slow.stopAll();
            bothLatched(true);
            rig.clock.aside(slow::release);
            bothLatched(false);

            rig.team.stopAll();
            rig.clock.until(slow::isLatched);
            rig.clock.aside(slow::release);
            bothLatched(false);
            blocked.set(false);
            never.raise();
        }
        slow.close();
    }

    private FakeConnection open(String clientId) {
        return rig.broker.open(ConnectOptions.of(clientId, new BotEnvironment(rig.clock.time(), Settings.inMemory())));
    }

    @Test
    void aStopWhileTheBrokerIsAwayIsPublishedWhenItIsBack() {
        rig.broker.stop();
        rig.clock.until(() -> !rig.sharing.isConnected() && !sharing.isConnected());
        rig.team.stopAll();
        rig.sleep(2);
        assertThat(other.isLatched()).isFalse();
        rig.broker.start();

        bothLatched(true);
    }

    @Test
    void aReleaseThatCameWhileADeskWasAwayReleasesItToo() {
        rig.team.stopAll();
        bothLatched(true);
        connection.cut();
        rig.clock.until(() -> !sharing.isConnected());
        rig.team.release();
        rig.sleep(2);
        assertThat(other.isLatched()).isTrue();
        connection.restore();

        bothLatched(false);
    }

    @Test
    void aBrokerThatForgetsIsToldOfTheStopAgain() {
        rig.team.stopAll();
        bothLatched(true);
        rig.broker.stop();
        rig.broker.forget();
        rig.clock.until(() -> !rig.sharing.isConnected() && !sharing.isConnected());
        rig.broker.start();

        rig.clock.until(() -> rig.broker.retained(TOPIC).isPresent());
        assertThat(kept().latched()).isTrue();
        assertThat(rig.team.isLatched() && other.isLatched()).isTrue();
    }

    @Test
    void aLateReleaseOfAnOldStopDoesNotEndANewerOne() {
        rig.team.stopAll();
        bothLatched(true);
        BrokerMessage release = release(kept().id());
        rig.team.release();
        bothLatched(false);
        other.stopAll();
        bothLatched(true);
        rig.broker.publish(release);
        rig.sleep(3);

        assertThat(rig.team.isLatched() && other.isLatched()).isTrue();
        assertThat(kept().latched()).isTrue();
    }

    private static BrokerMessage release(String... ids) {
        LatchMessage message = LatchMessage.release(Set.of(ids), new Sender("desk9", "Eve", "s"));
        return BrokerMessage.json(TOPIC, message.toJson(), Quality.AT_LEAST_ONCE)
                .retain();
    }

    @Test
    void stopsOfTwoDesksAtATimeAreReleasedTogether() {
        rig.team.stopAll();
        other.stopAll();
        bothLatched(true);
        rig.sleep(1);
        rig.team.release();

        bothLatched(false);
        rig.sleep(3);
        assertThat(rig.team.isLatched() || other.isLatched()).isFalse();
    }

    @Test
    void aReleaseOfOneOfTwoStopsLeavesTheOtherInForce() {
        rig.team.stopAll();
        bothLatched(true);
        String first = kept().id();
        other.stopAll();
        rig.clock.until(() -> !kept().id().equals(first));
        rig.sleep(1);
        rig.broker.publish(release(first));
        rig.sleep(3);

        assertThat(rig.team.isLatched() && other.isLatched()).isTrue();
        assertThat(kept().latched()).isTrue();
    }

    @Test
    void everythingDeliveredTwiceStopsAndReleasesOnce() {
        rig.broker.repeat();
        rig.team.stopAll();
        bothLatched(true);
        other.release();
        bothLatched(false);
        rig.sleep(3);

        assertThat(rig.team.isLatched() || other.isLatched()).isFalse();
    }

    @Test
    void aStopThatCannotBeReadIsAStopEachTime() {
        BrokerMessage stop = BrokerMessage.json(TOPIC, "STOP!!!", Quality.AT_LEAST_ONCE);
        rig.broker.publish(stop);
        bothLatched(true);
        rig.team.release();
        bothLatched(false);

        rig.broker.publish(stop);

        bothLatched(true);
    }

    @Test
    void aStopPressedWhileTheReleaseOfAnotherDeskTakesEffectStaysInForce() {
        other.stopAll();
        bothLatched(true);
        rig.sleep(1);
        rig.team.addListener(new TeamListener() {
            @Override
            public void latchChanged(boolean latched) {
                if (!latched) {
                    rig.team.removeListener(this);
                    rig.team.stopAll();
                }
            }
        });
        other.release();
        rig.sleep(3);

        assertThat(rig.team.isLatched() && other.isLatched()).isTrue();
        assertThat(kept().latched()).isTrue();
    }

    @Test
    void removingTheKeptStopChangesNothing() {
        rig.broker.publish(BrokerMessage.removing(TOPIC));
        rig.sleep(1);

        assertThat(rig.team.isLatched()).isFalse();
    }

    @Test
    void stopOfTheTeamBeforeItIsSharedIsThatOfTheSite() {
        Team late = new Team(rig.clock.time());
        late.stopAll();
        try (DeskSharing third = rig.sharing("desk4", late)) {
            third.start();
            bothLatched(true);
        }
        late.close();
    }

    @Test
    @SuppressWarnings("try")
    void aTeamOnOneSiteOverTwoConnectionsIsStoppedAndReleasedOnce() {
        FakeConnection using = open("using");
        using.connect();
        try (SiteLatch second = new SiteLatch(rig.team, using, "lab", rig.sharing.self())) {
            other.stopAll();
            bothLatched(true);
            rig.sleep(1);
            rig.team.release();
            bothLatched(false);
            rig.sleep(2);
            rig.team.stopAll();
            bothLatched(true);
            other.release();
            bothLatched(false);
            rig.sleep(2);
            assertThat(rig.team.isLatched() || other.isLatched()).isFalse();
            assertThat(rig.said.stream().filter(line -> line.startsWith("STOP by Bob at desk3")))
                    .hasSize(1);
        }
        assertThat(List.of(using.isConnected())).containsExactly(true);
    }

    @Test
    void aStopThatTheBrokerRefusesDoesNotLookAsIfTheSiteWereStopped() {
        connection.refuse(TOPIC);
        other.stopAll();

        rig.clock.until(() -> other.stopStatus().elsewhere().contains("(not authorized)"));
        assertThat(other.stopStatus().elsewhere())
                .startsWith("STOP has stopped only the robots of this program: the broker refuses it on " + TOPIC);
        rig.sleep(3);
        assertThat(rig.team.isLatched()).isFalse();

        other.release();
        assertThat(other.isLatched()).isFalse();
        assertThat(other.stopStatus().elsewhere()).isEmpty();
    }

    @Test
    void aReleaseThatTheBrokerRefusesReleasesNothing() {
        List<String> said = listen(other);
        rig.team.stopAll();
        bothLatched(true);
        connection.refuse(TOPIC);
        rig.sleep(1);

        other.release();
        rig.clock.until(() -> said.stream().anyMatch(line -> line.startsWith("not released: the broker refuses it")));
        rig.sleep(2);
        assertThat(rig.team.isLatched() && other.isLatched()).isTrue();
        assertThat(said).doesNotContain("latched: false");

        rig.team.release();
        bothLatched(false);
    }

    private static List<String> listen(Team team) {
        List<String> said = new CopyOnWriteArrayList<>();
        team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String message) {
                said.add(message);
            }

            @Override
            public void latchChanged(boolean latched) {
                said.add("latched: " + latched);
            }
        });
        return said;
    }

    @Test
    void aReleaseHasTakenEffectWhenItReturns() {
        rig.team.stopAll();
        bothLatched(true);
        rig.sleep(1);

        other.release();
        assertThat(other.isLatched()).isFalse();
    }

    @Test
    void aStopWithoutTheBrokerSaysThatItWaits() {
        rig.broker.stop();
        rig.clock.until(() -> !rig.sharing.isConnected() && !sharing.isConnected());
        other.stopAll();
        rig.clock.until(() -> other.stopStatus().elsewhere().contains("when the connection is back"));
        rig.broker.start();

        bothLatched(true);
        rig.clock.until(() -> other.stopStatus().elsewhere().isEmpty());
    }

    @Test
    void aReleaseWithoutTheBrokerLastsUntilTheStopOfTheSiteIsSeenAgain() {
        List<String> said = listen(other);
        rig.team.stopAll();
        bothLatched(true);
        rig.sleep(1);
        connection.unplug();
        rig.clock.until(() -> !sharing.isConnected());
        other.release();
        assertThat(other.isLatched()).isFalse();
        rig.clock.until(() -> said.stream().anyMatch(line -> line.startsWith("released only here: ")));
        connection.restore();

        bothLatched(true);
    }

    @Test
    void aMalformedMessageOnTheTopicOfStopIsAStopThatCanBeReleased() {
        rig.broker.publishMalformed(TOPIC, "its response topic \"a/+/b\" contains a wildcard");
        bothLatched(true);
        rig.clock.until(() -> rig.isSaid("STOP by a malformed message"));
        rig.sleep(1);

        other.release();
        bothLatched(false);
    }

    @Test
    @SuppressWarnings("try")
    void aTeamOnTwoSitesStopsBoth() {
        FakeConnection using = open("using");
        using.connect();
        try (SiteLatch second = new SiteLatch(rig.team, using, "hall", rig.sharing.self())) {
            rig.team.stopAll();
            bothLatched(true);
            rig.clock.until(() -> rig.broker.retained("hall/majic/1/stop").isPresent());
            rig.team.release();
            bothLatched(false);
            rig.clock.until(() -> !LatchMessage.parse(rig.broker
                            .retained("hall/majic/1/stop")
                            .orElseThrow()
                            .payload())
                    .latched());
        }
    }
}
