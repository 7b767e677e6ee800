package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import majic.bot.FakeBot;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.SiteTopics.Part;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests a desk against floods, and against messages that are wrong, huge, old or without a receiver. */
class UnwantedMessagesTest {
    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final RemoteUser anna = rig.user("desk1", "Anna").beat();

    private void publish(Part part, String payload) {
        anna.publish(part, payload.getBytes(StandardCharsets.UTF_8), Quality.AT_LEAST_ONCE, "x");
    }

    private boolean isObeyed() {
        return anna.outcome(anna.ask(new RequestedAction.Get("voltage"))).outcome() == Outcome.DONE;
    }

    @Test
    void aFloodOfRequestsIsCutAndReportedOnceAndTheDeskGoesOn() {
        for (int n = 0; n < 5000; n++) {
            anna.ask(new RequestedAction.Get("voltage"));
        }
        rig.sleep(2);

        assertThat(rig.said.stream().filter(line -> line.contains("left out"))).hasSize(1);
        assertThat(isObeyed()).isTrue();
    }

    @Test
    void aStopGetsThroughAFlood() {
        anna.move(900);
        rig.clock.until(() -> bot.state().moving());
        for (int n = 0; n < 5000; n++) {
            publish(Part.REQUEST, "{");
        }
        anna.stop();

        rig.clock.until(() -> bot.sent().contains("halt"));
        assertThat(anna.outcome("stop").outcome()).isEqualTo(Outcome.DONE);
    }

    @Test
    void aFloodOfWrongMessagesFillsNoLog() {
        for (int n = 0; n < 400; n++) {
            publish(Part.REQUEST, "{");
            publish(Part.HOLD, "{");
            rig.sleep(0.01);
        }

        assertThat(rig.said).hasSizeBetween(3, 12);
        assertThat(rig.isSaid("more messages that cannot be used)")).isTrue();
        assertThat(rig.broker.published("lab/majic/1/desks/desk2/robots/1/messages"))
                .hasSizeBetween(3, 12);
    }

    @Test
    void aFloodOfStopsIsCarriedOutAndEachIsAnswered() {
        for (int n = 0; n < 300; n++) {
            publish(Part.STOP, "{\"session\":\"s\",\"id\":\"" + n + "\"}");
        }

        rig.clock.until(() -> anna.replies("x").size() == 300);
        assertThat(bot.count("halt")).isBetween(1L, 300L);
        assertThat(isObeyed()).isTrue();
        rig.sleep(11);
        assertThat(rig.said.stream().filter(line -> line.contains("stopped by")))
                .hasSizeLessThan(60);
        assertThat(rig.isSaid("more times")).isTrue();
    }

    @ParameterizedTest
    @EnumSource(
            value = Part.class,
            names = {"REQUEST", "SPEED", "HOLD"})
    void whatIsWrongHugeOrEmptyMovesNothing(Part part) {
        List.of("", "null", "{", "[".repeat(500), "{\"session\":\"s\"}", "x".repeat(900_000))
                .forEach(payload -> publish(part, payload));
        rig.sleep(1);

        assertThat(isObeyed()).isTrue();
        assertThat(bot.sent()).isEmpty();
        assertThat(rig.team.member(1).owner()).isNull();
    }

    @Test
    void aWrongRequestIsAnsweredWithWhatIsWrong() {
        publish(Part.REQUEST, "{\"number\":1,\"session\":\"s\",\"do\":\"fly\"}");

        assertThat(anna.outcome("x").message()).startsWith("request: \"do\" is \"fly\"; it is one of move, turn");
    }

    @Test
    void aStopThatCannotBeReadStopsTheRobot() {
        anna.move(900);
        rig.clock.until(() -> bot.state().moving());
        publish(Part.STOP, "halt, please");

        rig.clock.until(() -> bot.sent().contains("halt"));
        rig.clock.until(() -> rig.isSaid("stopped by a message that cannot be read"));
    }

    @Test
    void aRequestThatTheBrokerKeptIsIgnored() {
        rig.sharing.close();
        String old = "{\"number\":1,\"session\":\"s\",\"validUntil\":900,\"do\":\"move\",\"mm\":500}";
        rig.broker.publish(BrokerMessage.json("lab/majic/1/desks/desk6/robots/1/request", old, Quality.AT_LEAST_ONCE)
                .retain());
        try (DeskSharing next = rig.sharing("desk6", rig.team)) {
            next.start();
            rig.clock.until(() -> rig.isSaid("is ignored: it may be old"));
        }
        assertThat(bot.sent()).doesNotContain("move 500");
    }

    @Test
    void anAnswerOutsideOfTheTopicForAnswersIsNotGivenAndTheRequestNotCarriedOut() {
        String move = "{\"number\":1,\"session\":\"s\",\"validUntil\":" + (anna.clockMs() + 900)
                + ",\"do\":\"move\",\"mm\":500}";
        anna.connection.publish(BrokerMessage.json(anna.topic(1, Part.REQUEST), move, Quality.AT_LEAST_ONCE)
                .answeredAt("lab/majic/1/stop", new byte[0]));

        rig.clock.until(() -> rig.isSaid("its response topic has to begin with lab/majic/1/replies/"));
        rig.sleep(1);
        assertThat(rig.broker.published("lab/majic/1/stop")).isEmpty();
        assertThat(bot.sent()).isEmpty();
    }

    @Test
    void aRequestForARobotThatIsNotThereIsRefused() {
        String topic = "lab/majic/1/desks/desk2/robots/9/request";
        anna.connection.publish(BrokerMessage.json(topic, "{}", Quality.AT_LEAST_ONCE)
                .answeredAt(
                        "lab/majic/1/replies/" + anna.sender.sessionHash(), "nine".getBytes(StandardCharsets.UTF_8)));

        assertThat(anna.outcome("nine").message()).isEqualTo("desk2 has no robot 9 (it shares 1)");
    }

    @Test
    void aPresenceThatCannotBeReadIsReported() {
        rig.broker.publish(
                BrokerMessage.json("lab/majic/1/desks/desk8/presence", "{\"state\":1}", Quality.AT_LEAST_ONCE));

        rig.clock.until(() -> rig.isSaid("desk8: presence: \"state\" is 1; it is a text"));
    }
}
