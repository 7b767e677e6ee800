package majic.shared.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import majic.bot.Beam;
import majic.bot.BotCommand;
import majic.bot.BotProfile;
import majic.bot.MajicBot.Connection;
import majic.bot.MotionReport;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.shared.message.RequestReply.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the messages between desks: what is written can be read, and what others send is read with care. */
class SharedMessagesTest {
    private static final Sender ANNA = new Sender("desk1", "Anna", "s-1");
    private static final BotProfile PROFILE =
            new BotProfile(250, new Range(-1500, 1500), new Range(-300, 300), 20, 10, 300, 60, 400, false);

    private static final RangeSensor LASER = RangeSensor.laser(new Pose(20, 0, 0), 361, -90, 0.5, 32_000, 10);
    private static final RangeSensor SONAR = new RangeSensor(
            "sonar",
            List.of(
                    new Beam(new Pose(100, 50, 30), 30, 150, 5000, 20),
                    new Beam(new Pose(100, -50, -30), 30, 150, 5000, 20)));

    private static final String DESCRIPTION_WITHOUT_END = "{\"version\":1,\"session\":\"s\",\"type\":\"cart\","
            + "\"profile\":{\"bodyMm\":1,\"speed\":{},\"turn\":{},\"cruiseMmPerSec\":1,\"cruiseTurnDegPerSec\":1,"
            + "\"nearMm\":1}";

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static String text(byte[] json) {
        return new String(json, StandardCharsets.UTF_8);
    }

    @Test
    void theHashOfASessionCanBeDerivedInAnyLanguage() {
        assertThat(ANNA.sessionHash()).isEqualTo("6a840baf5d8c3ff2");
    }

    @Test
    void everyActionOfARequestIsReadAsItWasWritten() {
        List<RequestedAction> actions = List.of(
                new RequestedAction.Move(-300.5, "distanceFront < 300 mm"),
                new RequestedAction.Turn(90, ""),
                new RequestedAction.Drive(200, -10, 2.5, "bumped"),
                new RequestedAction.GoTo(new Pose(1500, -300, 90), true, "bumped"),
                new RequestedAction.GoTo(new Pose(1500, -300, 0), false, ""),
                new RequestedAction.Get("voltage"),
                new RequestedAction.Set("headPan", List.of(Value.of(30, Unit.NONE), Value.text("500ms"))),
                new RequestedAction.Run("wag", List.of(Value.of(2, Unit.NONE), Value.yesNo(true))),
                new RequestedAction.Hold(),
                new RequestedAction.Free(),
                new RequestedAction.Picture(),
                new RequestedAction.Scans(),
                new RequestedAction.Localize());

        for (RequestedAction action : actions) {
            Request request = new Request(ANNA, 17, OptionalLong.of(4711), action);
            assertThat(Request.parse(request.toJson())).isEqualTo(request);
        }
    }

    @Test
    void theOtherMessagesAreReadAsTheyWereWritten() {
        Presence presence = new Presence(Presence.State.ONLINE, ANNA, "MAJIC 2.1", List.of(1, 3));
        SpeedMessage speed = new SpeedMessage(ANNA, 18, 120.5, -3, 99);
        HoldMessage hold = new HoldMessage(ANNA, 100);
        StopMessage stop = new StopMessage(ANNA, 18, "x");
        LatchMessage latch = LatchMessage.stop("id-1", ANNA, Instant.parse("2026-01-05T12:00:07Z"));
        LatchMessage release = LatchMessage.release(Set.of("id-1", "id-2"), ANNA);
        ScanMessage scan = new ScanMessage(
                5,
                20,
                "laser",
                new Pose(1.25, -2, 90),
                List.of(300, ScanMessage.NO_ECHO, ScanMessage.NOTHING_MEASURED));
        RobotMessage line = new RobotMessage(RobotMessage.Kind.ALARM, "connection lost");

        assertThat(Presence.parse(presence.toJson())).isEqualTo(presence);
        assertThat(SpeedMessage.parse(speed.toJson())).isEqualTo(speed);
        assertThat(HoldMessage.parse(hold.toJson())).isEqualTo(hold);
        assertThat(StopMessage.parse(stop.toJson())).isEqualTo(stop);
        assertThat(LatchMessage.parse(latch.toJson())).isEqualTo(latch);
        assertThat(LatchMessage.parse(release.toJson())).isEqualTo(release);
        assertThat(ScanMessage.parse(scan.toJson())).isEqualTo(scan);
        assertThat(RobotMessage.parse(line.toJson())).isEqualTo(line);
    }

    @Test
    void aReplyKeepsAmountAndTime() {
        RequestReply reply = RequestReply.done(new MotionReport(Value.about(498, Unit.MM), 2.125));

        assertThat(RequestReply.parse(reply.toJson())).isEqualTo(reply);
        assertThat(RequestReply.parse(RequestReply.of(RequestReply.Outcome.REFUSED, "1 is held by Bob at desk3")
                                .toJson())
                        .message())
                .isEqualTo("1 is held by Bob at desk3");
    }

    @Test
    void aDescriptionKeepsParametersAndCommands() {
        Parameter pan = Parameter.number("headPan", Unit.DEG, "left positive")
                .within(-91, 91)
                .with(Parameter.number("time", Unit.S, "how long"))
                .access(true, true, true);
        Parameter posture = Parameter.choice("posture", List.of("stand", "sit"), "how it stands");
        Description description = new Description(
                "s-2",
                "Rex",
                new Description.Kind("aibo", "Aibo", "Sony Aibo"),
                "a Sony Aibo",
                PROFILE,
                true,
                List.of("posture"),
                List.of(pan, posture, Parameter.list("sonar", Unit.MM, "all")),
                List.of(new BotCommand("wag", List.of(pan), List.of(posture), true, "wags", false)),
                List.of(LASER, SONAR));

        assertThat(Description.parse(description.toJson())).isEqualTo(description);
    }

    @Test
    void theBeamsOfALaserScannerAreDescribedByTheirAngles() {
        Description described = Description.parse(bytes(DESCRIPTION_WITHOUT_END
                + ",\"sensors\":[{\"name\":\"laser\",\"beams\":[[-1,20,0,1,0,8000,10],[0],[1]]}]}"));

        assertThat(described.sensors()).containsExactly(RangeSensor.laser(new Pose(20, 0, 0), 3, -1, 1, 8000, 10));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "[]",
                "[[0]]",
                "[[0,20,0,1,0,8000,10],[1,\"\"]]",
                "[[0,20,0,1,9000,8000,10]]",
                "[[0,20,0,1,0,8000,10,5]]",
                "[[0,20,0,1,0,8000,10],7]",
                "7"
            })
    void aSensorWithImpossibleBeamsIsRefused(String beams) {
        String description = DESCRIPTION_WITHOUT_END + ",\"sensors\":[{\"name\":\"laser\",\"beams\":" + beams + "}]}";

        assertThatThrownBy(() -> Description.parse(bytes(description)))
                .isInstanceOf(UnusableMessageException.class)
                .hasMessageStartingWith("description: sensors: \"beams\" is ");
    }

    @Test
    void aScanIsThatOfTheSensorThatTheRobotDescribes() {
        RangeScan measured = new RangeScan(SONAR, 7, new Pose(100, 200, 45), 1234.4f, Float.POSITIVE_INFINITY);

        RangeScan read =
                ScanMessage.parse(ScanMessage.of(5, 20, measured).toJson()).scan(SONAR, 9);

        assertThat(read.timeS()).isEqualTo(9);
        assertThat(read.odometry()).isEqualTo(measured.odometry());
        assertThat(read.rangeMm(0)).isEqualTo(1234);
        assertThat(read.rangeMm(1)).isInfinite();
        assertThatThrownBy(() -> ScanMessage.of(5, 20, measured).scan(LASER, 9))
                .hasMessage("scan: it has 2 distances; the sensor has 361 beams");
    }

    @ParameterizedTest
    @ValueSource(strings = {"[1.5]", "[-3]", "[\"1\"]", "[null]", "[9999999999]", "{}"})
    void aScanWithImpossibleDistancesIsRefused(String ranges) {
        assertThatThrownBy(() -> ScanMessage.parse(bytes("{\"clock\":1,\"sensor\":\"laser\","
                        + "\"odometry\":{\"x\":0,\"y\":0,\"heading\":0},\"ranges\":" + ranges + "}")))
                .isInstanceOf(UnusableMessageException.class)
                .hasMessageStartingWith("scan: \"ranges\" is ");
    }

    @Test
    void aStateKeepsEachKindOfValue() {
        Parameter distance = Parameter.number("distanceFront", Unit.MM, "");
        Map<String, Value> values = Map.of(
                "number", Value.of(12.3, Unit.MM),
                "estimate", Value.about(12, Unit.MM),
                "clear", Value.CLEAR,
                "unknown", Value.unknown("no reading yet"),
                "list", Value.many(List.of(Value.of(1, Unit.MM), Value.CLEAR)),
                "flag", Value.yesNo(true));

        values.forEach((name, value) -> assertThat(ValueJson.read(ValueJson.of(value), distance))
                .as(name)
                .isEqualTo(value));
        RobotState state = new RobotState(
                5,
                new RobotState.Link(Connection.LOST, "cable pulled"),
                new RobotState.Movement(new Pose(1, 2, 3), new Pose(10, 20, 30), true, 4, 5, true, 6),
                true,
                3,
                new RobotState.Holder("desk1", "Anna", "0123456789abcdef", "WanderDog"),
                "not confirmed within 0.8 s",
                Map.of("voltage", ValueJson.of(Value.of(12.6, Unit.V))));
        assertThat(RobotState.parse(state.toJson())).isEqualTo(state);
    }

    @Test
    void fieldsOfANewerVersionAreIgnoredAndItsWordsShownAsText() {
        assertThat(HoldMessage.parse(bytes("{\"session\":\"s\",\"validUntil\":1,\"mood\":[1]}"))
                        .validUntil())
                .isEqualTo(1);
        Description newer = Description.parse(bytes(DESCRIPTION_WITHOUT_END
                + ",\"parameters\":[{\"name\":\"smell\",\"kind\":\"odour\",\"unit\":\"sniff\"}]}"));

        assertThat(newer.parameters()).containsExactly(Parameter.text("smell", ""));
        assertThat(newer.profile().speed()).isEqualTo(Range.ANY);
        assertThat(ValueJson.read(
                        JsonNodeFactory.instance.objectNode().put("rgb", 7),
                        newer.parameters().get(0)))
                .isEqualTo(Value.text("{\"rgb\":7}"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "null", "[]", "17", "{", "{\"do\":\"move\"", "{} {}", "\u0000\u0001"})
    void whatIsNoJsonObjectIsRefusedWithASentence(String payload) {
        assertThatThrownBy(() -> Request.parse(bytes(payload)))
                .isInstanceOf(UnusableMessageException.class)
                .hasMessageStartingWith("request: ")
                .hasMessageNotContaining("Source");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{}|\"number\" is missing; it is a whole number",
                "{\"number\":0,\"session\":\"s\",\"do\":\"hold\"}|counts the requests of the session from 1 on",
                "{\"number\":1,\"do\":\"hold\"}|\"session\" is missing; it is a text",
                "{\"number\":1,\"session\":\"a b\",\"do\":\"hold\"}|\"session\" is \"a b\"; it is 1 to 64 letters",
                "{\"number\":1,\"session\":\"s\",\"desk\":\"/\",\"do\":\"hold\"}|\"desk\" is \"/\"; it is a letter",
                "{\"number\":1,\"session\":\"s\",\"do\":\"fly\"}|\"do\" is \"fly\"; it is one of move, turn",
                "{\"number\":1,\"session\":\"s\",\"do\":\"move\",\"mm\":\"5\"}|\"mm\" is \"5\"; it is a number",
                "{\"number\":1,\"session\":\"s\",\"do\":\"set\",\"parameter\":\"x\",\"values\":[{}]}|a value is a number",
            })
    void aWrongFieldIsNamedWithWhatWouldBeRight(String payload, String sentence) {
        assertThatThrownBy(() -> Request.parse(bytes(payload))).hasMessageContaining(sentence);
    }

    @Test
    void aHugeOrDeepMessageIsRefusedBeforeItIsRead() {
        assertThatThrownBy(() -> Request.parse(new byte[Request.MOST_BYTES + 1]))
                .hasMessage("request: 65537 bytes are too many; at most 65536 are read");
        assertThatThrownBy(() -> Request.parse(bytes("[".repeat(1000)))).hasMessageContaining("is not JSON");
    }

    @Test
    void namesOfOthersCannotForgeALine() {
        Request forged = Request.parse(
                bytes("{\"number\":1,\"session\":\"s\",\"desk\":\"d\",\"person\":\"Eve\\n1: STOP\",\"do\":\"free\"}"));

        assertThat(forged.sender()).hasToString("Eve\\n1: STOP at d");
        assertThat(text(forged.toJson())).doesNotContain("\n");
    }

    @Test
    void noAnswerContainsHalfACharacter() {
        String longNumber = "x".repeat(58) + "\uD83D\uDE00";
        assertThatThrownBy(() -> Request.parse(bytes("{\"number\":\"" + longNumber + "\"}")))
                .satisfies(refused ->
                        RequestReply.of(Outcome.REFUSED, refused.getMessage()).toJson());
        Request half =
                Request.parse(bytes("{\"number\":1,\"session\":\"s\",\"do\":\"get\",\"parameter\":\"\\ud83d\"}"));
        assertThat(half.action()).isEqualTo(new RequestedAction.Get("\uFFFD"));
        Sender named = Sender.ofThisRun("desk1", "x".repeat(39) + "\uD83D\uDE00");
        assertThat(named.person()).isEqualTo("x".repeat(39));
    }

    @Test
    void aSenderThatNamesNoDeskIsWrittenWithoutOne() {
        Request unnamed = Request.parse(bytes("{\"number\":1,\"session\":\"s\",\"do\":\"free\"}"));

        assertThat(unnamed.sender().desk()).startsWith("session ");
        assertThat(Request.parse(unnamed.toJson())).isEqualTo(unnamed);
    }

    @Test
    void topicsAreReadAsTheyAreWritten() {
        SiteTopics topics = new SiteTopics("school/lab");

        assertThat(topics.robot("desk2", 7, SiteTopics.Part.REQUEST))
                .isEqualTo("school/lab/majic/1/desks/desk2/robots/7/request");
        assertThat(topics.ofRobot("school/lab/majic/1/desks/desk2/robots/7/request"))
                .contains(new SiteTopics.OfRobot("desk2", 7, SiteTopics.Part.REQUEST));
        assertThat(topics.deskOfPresence(topics.presence("desk2"))).contains("desk2");
        assertThat(topics.ofRobot("lab/majic/1/desks/desk2/robots/7/request")).isEmpty();
        assertThat(topics.ofRobot("school/lab/majic/1/desks/desk2/robots/x/request"))
                .isEmpty();
        assertThat(topics.stop()).isEqualTo("school/lab/majic/1/stop");
    }
}
