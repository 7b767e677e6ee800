package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import majic.bot.FakeBot;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.Description;
import majic.shared.message.Presence;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotMessage;
import majic.shared.message.RobotState;
import majic.shared.message.StateChange;
import majic.team.Member;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests what a desk publishes of its robots, and when. */
class PublishedRobotsTest {
    private static final String ROBOT = "lab/majic/1/desks/desk2/robots/";

    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final Member member = rig.team.member(1);
    private final FakeBot bot = (FakeBot) BotDriver.of(member.bot());

    private Description description(int robot) {
        return Description.parse(rig.broker
                .retained(ROBOT + robot + "/description")
                .orElseThrow()
                .payload());
    }

    private RobotState state() {
        return RobotState.parse(
                rig.broker.retained(ROBOT + "1/state").orElseThrow().payload());
    }

    private long published(String topic) {
        return rig.broker.published(ROBOT + topic).size();
    }

    private void described() {
        rig.clock.until(() -> rig.broker.retained(ROBOT + "1/description").isPresent());
    }

    @Test
    void aDescriptionHasWhatTheRobotOffers() {
        described();

        assertThat(description(1).parameters()).isEqualTo(bot.parameters());
        assertThat(description(1).commands()).isEqualTo(bot.commands());
        assertThat(description(1).profile()).isEqualTo(bot.profile());
        assertThat(description(1).calibration()).containsExactly("posture");
        assertThat(description(1).kind().type()).isEqualTo(bot.type().name());
    }

    @Test
    void aRobotThatReportsNothingIsPublishedOnceASecond() {
        rig.sleep(2);
        long before = published("1/state");
        rig.sleep(10);

        assertThat(published("1/state") - before).isBetween(9L, 11L);
    }

    @Test
    void changesOfARobotThatReportsAllTheTimeArePublishedTenTimesASecondBetweenItsStates() {
        rig.sleep(1);
        long states = published("1/state");
        long changes = published("1/changes");
        for (int n = 0; n < 500; n++) {
            bot.tell("voltage", Value.of(n, Unit.V));
            rig.sleep(0.01);
        }

        assertThat(published("1/state") - states).isBetween(4L, 6L);
        assertThat(published("1/changes") - changes).isBetween(38L, 47L);
    }

    @Test
    void theClockOfAHeldRobotThatReportsNothingIsPublishedFourTimesASecond() {
        rig.user("desk1", "Anna").beat().ask(new RequestedAction.Hold());
        rig.sleep(2);
        long before = published("1/state") + published("1/changes");
        rig.sleep(10);

        assertThat(published("1/state") + published("1/changes") - before).isBetween(33L, 51L);
        assertThat(newestChange().values()).isEmpty();
        assertThat(newestChange().course()).isNull();
    }

    @Test
    void aChangeHasWhatIsDifferentAndNothingElse() {
        described();
        rig.sleep(0.5);
        bot.tell("voltage", Value.of(12, Unit.V));
        rig.sleep(0.2);

        assertThat(newestChange().values()).containsOnlyKeys("voltage");
        assertThat(newestChange().values().get("voltage")).hasToString("12");
        assertThat(newestChange().course()).isNull();
        assertThat(rig.broker.retained(ROBOT + "1/changes")).isEmpty();
    }

    private StateChange newestChange() {
        List<BrokerMessage> all = rig.broker.published(ROBOT + "1/changes");
        return StateChange.parse(all.get(all.size() - 1).payload());
    }

    @Test
    void aRobotThatRepeatsTheSameIsPublishedOnceASecond() {
        rig.sleep(2);
        long states = published("1/state");
        long changes = published("1/changes");
        for (int n = 0; n < 500; n++) {
            bot.tell("voltage", Value.of(12, Unit.V));
            rig.sleep(0.01);
        }

        assertThat(published("1/state") - states).isBetween(4L, 6L);
        assertThat(published("1/changes") - changes).isBetween(0L, 1L);
    }

    @Test
    void aChangeOfAConditionIsPublishedAtOnce() {
        described();
        bot.reportSpeed(100);
        rig.sleep(0.01);
        assertThat(state().motion().moving()).isTrue();

        rig.team.stopAll();
        rig.sleep(0.01);
        assertThat(state().latched()).isTrue();

        bot.cut();
        rig.sleep(0.01);
        assertThat(state().link().connection()).isEqualTo(Connection.LOST);
        assertThat(state().link().lostReason()).isEqualTo("connection lost");
    }

    @Test
    void aStateHasPlaceValuesAndTheReasonOfAnUnconfirmedStop() {
        member.bot().place(new Pose(1000, -200, 90));
        bot.putObstacle(700);
        bot.getStuck();
        rig.team.stop(List.of(member), null);
        rig.clock.until(() -> rig.team.stopStatus().problem(1).isPresent());
        rig.sleep(0.05);

        assertThat(state().motion().pose()).isEqualTo(new Pose(1000, -200, 90));
        assertThat(state().motion().placed()).isTrue();
        assertThat(state().values().get("distanceFront")).hasToString("700");
        assertThat(state().stopProblem()).contains("takes no more data");
        bot.comeLoose();
    }

    @Test
    void aStateThatIsNotRenewedExpires() {
        described();
        rig.connection().kill();
        rig.sleep(3.1);

        assertThat(rig.broker.retained(ROBOT + "1/state")).isEmpty();
    }

    @Test
    void aNewNameIsPublished() {
        described();
        rig.team.rename(member, "Rex");

        rig.clock.until(() -> description(1).name().equals("Rex"));
    }

    @Test
    void robotsComeAndGo() {
        rig.add();
        rig.clock.until(() -> rig.broker.retained(ROBOT + "2/description").isPresent());
        rig.team.remove(2);

        rig.clock.until(() -> rig.broker.retained(ROBOT + "2/description").isEmpty());
        rig.clock.until(() -> rig.broker.retained(ROBOT + "2/state").isEmpty());
        rig.sleep(2);
        Presence presence = Presence.parse(rig.broker
                .retained("lab/majic/1/desks/desk2/presence")
                .orElseThrow()
                .payload());
        assertThat(presence.robots()).containsExactly(1);
        assertThat(rig.broker.retained(ROBOT + "2/state")).isEmpty();
    }

    @Test
    void aRobotThatIsReplacedByAnotherIsDescribedAnewAndNotHeldAnyMore() {
        described();
        RemoteUser anna = rig.user("desk1", "Anna").beat();
        anna.move(900);
        rig.clock.until(() -> bot.state().moving());
        rig.team.remove(1);
        FakeBot next = FakeBot.on(rig.clock.time());
        next.connect();
        rig.team.rename(rig.team.add(next, OptionalInt.of(1)), "Next");

        rig.clock.until(() -> rig.broker.retained(ROBOT + "1/description").isPresent()
                && description(1).name().equals("Next"));
        assertThat(rig.team.member(1).owner()).isNull();
        rig.sleep(2);
        assertThat(next.sent()).noneMatch(sent -> sent.startsWith("move"));
    }

    @Test
    void onlyChosenRobotsAreShared() {
        rig.add();
        rig.add();
        DeskSharing chosen =
                new DeskSharing(rig.team, new DeskOptions("lab", "desk5", "Bob", "", Set.of(3), false), rig::open);
        try (chosen) {
            chosen.start();
            assertThat(chosen.robots()).containsExactly(3);
        }
    }

    @Test
    void messagesAndAnswersArePublishedWithoutTheNumber() {
        bot.notice("motors are on");
        rig.clock.until(() -> lines().contains(new RobotMessage(RobotMessage.Kind.MESSAGE, "motors are on")));
        bot.cut();

        rig.clock.until(
                () -> lines().contains(new RobotMessage(RobotMessage.Kind.ALARM, "connection lost: connection lost")));
    }

    private List<RobotMessage> lines() {
        return rig.broker.published(ROBOT + "1/messages").stream()
                .map(BrokerMessage::payload)
                .map(RobotMessage::parse)
                .toList();
    }

    @Test
    void everythingIsPublishedAgainWhenTheBrokerIsBackWithoutMemory() {
        described();
        rig.broker.stop();
        rig.broker.forget();
        rig.clock.until(() -> !rig.sharing.isConnected());
        rig.broker.start();

        described();
        rig.clock.until(
                () -> rig.broker.retained("lab/majic/1/desks/desk2/presence").isPresent());
        rig.clock.until(() -> rig.isSaid("sharing goes on: connected with the broker again"));
    }
}
