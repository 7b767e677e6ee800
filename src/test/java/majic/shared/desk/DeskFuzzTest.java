package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import majic.bot.FakeBot;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.SiteTopics.Part;
import majic.text.OneSentence;

/**
 * Arbitrary messages to a desk that shares a robot: kept inputs in every build, new ones with {@code mvn -Pfuzz test}
 * (see CONTRIBUTING.md).
 */
class DeskFuzzTest {
    private static final List<Part> PARTS = List.of(Part.REQUEST, Part.SPEED, Part.HOLD, Part.STOP);
    private static final int MOST_MESSAGES = 8;

    /** How a robot notes what moves it. */
    private static final Pattern MOTION = Pattern.compile("(?m)^(move|turn|drive|headPan) ");

    @FuzzTest
    void afterAnyMessagesAStopHaltsTheRobotAndTheDeskAnswers(byte[] lines) {
        try (SharingRig rig = SharingRig.started()) {
            FakeBot bot = rig.bot();
            RemoteUser anna = rig.user("desk1", "Anna").beat();
            publish(anna, lines);
            rig.sleep(0.1);
            anna.stop();
            rig.clock.until(() -> bot.sent().contains("halt"));
            rig.sleep(2);

            assertThat(motionsAfterTheLastHalt(bot)).isFalse();
            assertThat(rig.said).allSatisfy(OneSentence::check);
            RequestedAction get = new RequestedAction.Get("voltage");
            assertThat(anna.outcome(anna.ask(get)).outcome()).isEqualTo(Outcome.DONE);
            anna.stopBeating();
        }
    }

    /** The first byte of a line selects the topic. */
    private static void publish(RemoteUser anna, byte[] lines) {
        new String(lines, StandardCharsets.ISO_8859_1)
                .lines()
                .filter(line -> !line.isEmpty())
                .limit(MOST_MESSAGES)
                .map(line -> line.getBytes(StandardCharsets.ISO_8859_1))
                .forEach(line -> anna.publish(
                        PARTS.get(line[0] & 3), Arrays.copyOfRange(line, 1, line.length), Quality.AT_LEAST_ONCE, "x"));
    }

    private static boolean motionsAfterTheLastHalt(FakeBot bot) {
        List<String> sent = bot.sent();
        return MOTION.matcher(String.join("\n", sent.subList(sent.lastIndexOf("halt") + 1, sent.size())))
                .find();
    }

    @FuzzTest
    void anyStopOfTheSiteIsObeyedOrAReleaseAndCanBeReleased(byte[] payload) {
        try (SharingRig rig = SharingRig.started()) {
            rig.broker.publish(BrokerMessage.json("lab/majic/1/stop", payload, Quality.AT_LEAST_ONCE));
            rig.sleep(1);
            rig.team.release();
            rig.sleep(1);

            assertThat(rig.team.isLatched()).isFalse();
            assertThat(rig.said).allSatisfy(OneSentence::check);
        }
    }
}
