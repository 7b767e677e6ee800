package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Stream;
import majic.bot.FakeBot;
import majic.bot.Unit;
import majic.bot.Value;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.team.Owner;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests what a desk does with requests to its robots. */
class SharedRequestsTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    private List<String> motions() {
        return bot.sent().stream()
                .filter(sent -> Stream.of("move", "turn", "drive", "headPan").anyMatch(sent::startsWith))
                .toList();
    }

    @Test
    void aMoveIsAcceptedAndThenDoneWithItsDistance() {
        long request = anna.ask(new RequestedAction.Move(500, ""));

        RequestReply reply = anna.outcome(request);

        assertThat(anna.replies(request))
                .extracting(RequestReply::outcome)
                .containsExactly(Outcome.ACCEPTED, Outcome.DONE);
        assertThat(reply.report()).isNotNull();
        assertThat(reply.report().amount()).isEqualTo(Value.of(500, Unit.MM));
        assertThat(motions()).containsExactly("move 500");
        rig.clock.until(() -> rig.isSaid("1 move 500 (Anna at desk1): done (500 mm"));
    }

    @Test
    void aRequestThatIsDoneAtOnceHasOneAnswer() {
        long request = anna.ask(new RequestedAction.Set("light", List.of(Value.yesNo(true))));
        anna.outcome(request);
        rig.sleep(1);

        assertThat(anna.replies(request)).extracting(RequestReply::outcome).containsExactly(Outcome.DONE);
    }

    @Test
    void theStateBeforeTheAnswerShowsTheRobotAtRest() {
        anna.outcome(anna.ask(new RequestedAction.Move(200, "")));

        assertThat(anna.state().motion().moving()).isFalse();
        assertThat(anna.state().motion().pose().xMm()).isEqualTo(200);
    }

    @Test
    void aConditionIsEvaluatedWhereTheRobotIs() {
        bot.putObstacle(1000);
        anna.outcome(anna.ask(new RequestedAction.Move(900, "distanceFront < 600mm")));

        assertThat(anna.state().motion().pose().xMm()).isBetween(400.0, 500.0);
    }

    @Test
    void aConditionThatDoesNotFitTheRobotIsRefused() {
        RequestReply unknown = anna.outcome(anna.ask(new RequestedAction.Move(900, "smell > 3")));
        RequestReply another = anna.outcome(anna.ask(new RequestedAction.Move(900, "bumped\n1 stop")));
        RequestReply trailing = anna.outcome(anna.ask(new RequestedAction.Move(900, "bumped == yes 1 stop")));

        assertThat(unknown.outcome()).isEqualTo(Outcome.REFUSED);
        assertThat(unknown.message()).contains("smell");
        assertThat(another.outcome()).isEqualTo(Outcome.REFUSED);
        assertThat(trailing.outcome()).isEqualTo(Outcome.REFUSED);
        assertThat(motions()).isEmpty();
    }

    @Test
    void valuesAreReadAndSet() {
        RequestReply read = anna.outcome(anna.ask(new RequestedAction.Get("voltage")));
        anna.outcome(anna.ask(new RequestedAction.Set("light", List.of(Value.yesNo(true)))));
        anna.outcome(anna.ask(new RequestedAction.Set("headPan", List.of(Value.of(30, Unit.NONE)))));

        assertThat(read.value()).hasToString("12.6");
        assertThat(anna.state().values().get("light")).hasToString("true");
        assertThat(anna.state().values().get("headPan")).hasToString("30");
        assertThat(motions()).containsExactly("headPan 30");
    }

    @Test
    void aCommandOfTheRobotIsRun() {
        RequestReply reply = anna.outcome(anna.ask(new RequestedAction.Run("wag", List.of(Value.of(3, Unit.NONE)))));

        assertThat(reply.text()).isEqualTo("wagged 3");
    }

    @Test
    void whatIsWrongIsRefusedWithTheSentenceOfTheRobot() {
        assertThat(anna.outcome(anna.ask(new RequestedAction.Move(1e6, ""))).message())
                .contains("maxMove");
        assertThat(anna.outcome(anna.ask(new RequestedAction.Get("smell"))).message())
                .contains("smell");
        assertThat(anna.outcome(anna.ask(new RequestedAction.Run("fly", List.of())))
                        .message())
                .contains("fly");
        assertThat(anna.outcome(anna.ask(new RequestedAction.Picture())).message())
                .contains("no camera");
    }

    @Test
    void aRequestThatComesTooLateIsRefused() {
        RequestReply reply =
                anna.outcome(anna.ask(1, OptionalLong.of(anna.clockMs() - 4200), new RequestedAction.Move(500, "")));

        assertThat(reply.outcome()).isEqualTo(Outcome.REFUSED);
        assertThat(reply.message()).isEqualTo("came 4.2 s too late; nothing was done");
        assertThat(motions()).isEmpty();
    }

    @Test
    void aTimeOfAnotherClockIsRefusedWithWhatWouldBeRight() {
        RequestReply reply =
                anna.outcome(anna.ask(1, OptionalLong.of(1_763_800_000_000L), new RequestedAction.Move(500, "")));

        assertThat(reply.message()).contains("add at most 5000 to the \"clock\" of the last state");
    }

    @Test
    void onlyQuestionsNeedNoTime() {
        assertThat(anna.outcome(anna.ask(1, OptionalLong.empty(), new RequestedAction.Move(500, "")))
                        .message())
                .startsWith("\"validUntil\" is missing");
        assertThat(anna.outcome(anna.ask(2, OptionalLong.empty(), new RequestedAction.Get("voltage")))
                        .outcome())
                .isEqualTo(Outcome.DONE);
    }

    @Test
    void everythingThatAnOutageHeldBackIsRefusedWhenItArrivesAtOnce() {
        anna.connection.holdBack();
        anna.move(500);
        anna.move(-500);
        rig.sleep(3);
        anna.connection.deliver();

        assertThat(anna.outcome(1).message()).contains("too late");
        assertThat(anna.outcome(2).message()).contains("too late");
        assertThat(motions()).isEmpty();
    }

    @Test
    void aRequestThatIsDeliveredTwiceIsExecutedOnceAndAnsweredAgain() {
        rig.broker.repeat();
        long request = anna.ask(new RequestedAction.Move(500, ""));
        anna.outcome(request);

        assertThat(motions()).containsExactly("move 500");
        anna.ask(request, OptionalLong.of(anna.clockMs() + 1000), new RequestedAction.Move(500, ""));
        rig.clock.until(() -> anna.replies(request).stream()
                        .filter(reply -> reply.outcome() == Outcome.DONE)
                        .count()
                > 1);
        assertThat(motions()).containsExactly("move 500");
    }

    @Test
    void theQueueIsThatOfTheRobot() {
        long first = anna.ask(new RequestedAction.Move(500, ""));
        long second = anna.ask(new RequestedAction.Turn(90, ""));
        anna.outcome(second);

        assertThat(anna.replies(first)).hasSize(2);
        assertThat(motions()).containsExactly("move 500", "turn 90");
    }

    @Test
    void theFirstMotionClaimsTheRobotUntilItIsNotUsedForFiveSeconds() {
        anna.outcome(anna.ask(new RequestedAction.Move(200, "")));

        assertThat(rig.team.member(1).owner()).extracting(Owner::kind).isEqualTo(Owner.Kind.REMOTE);
        assertThat(anna.state().holder()).hasToString("Anna at desk1");
        rig.sleep(4.5);
        assertThat(rig.team.member(1).owner()).isNotNull();
        rig.sleep(1);
        assertThat(rig.team.member(1).owner()).isNull();
        anna.until(state -> state.holder() == null);
        assertThat(bot.sent()).doesNotContain("halt");
    }

    @Test
    void aHoldLastsUntilItIsGivenBack() {
        anna.outcome(anna.ask(new RequestedAction.Hold()));
        rig.sleep(20);
        assertThat(anna.state().holder()).hasToString("Anna at desk1");

        anna.outcome(anna.ask(new RequestedAction.Free()));

        assertThat(anna.state().holder()).isNull();
        assertThat(rig.team.member(1).owner()).isNull();
    }
}
