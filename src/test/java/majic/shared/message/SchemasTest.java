package majic.shared.message;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import majic.bot.BotCommand;
import majic.bot.BotProfile;
import majic.bot.MajicBot.Connection;
import majic.bot.MotionReport;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Compares the messages between desks with the schemas in {@code docs/schemas}, which other programs are written from.
 */
class SchemasTest {
    private static final ObjectMapper MAPPER = new ObjectMapper();
    private static final Path FOLDER = Path.of("docs", "schemas");
    private static final Sender ANNA = new Sender("desk1", "Anna", "s-1");

    /** One of each kind of message, with every field that its kind can have. */
    private static Map<String, List<byte[]>> messages() {
        Map<String, List<byte[]>> all = new TreeMap<>();
        all.put("latch", List.of(LatchMessage.stop("id-1", ANNA, Instant.EPOCH).toJson(), release()));
        all.put("presence", presences());
        all.put("description", List.of(description().toJson()));
        all.put("state", List.of(state(true).toJson(), state(false).toJson()));
        all.put("changes", changes());
        all.put("scans", List.of(new ScanMessage(5, 20, "laser", Pose.START, List.of(300, -1, -2)).toJson()));
        all.put("message", List.of(new RobotMessage(RobotMessage.Kind.ALARM, "connection lost").toJson()));
        all.put("request", requests());
        all.put("reply", replies());
        all.put("speed", List.of(new SpeedMessage(ANNA, 18, 120.5, -3, 99).toJson()));
        all.put("stop", List.of(new StopMessage(ANNA, 18, "x").toJson()));
        all.put("hold", List.of(new HoldMessage(ANNA, 100).toJson()));
        return all;
    }

    private static byte[] release() {
        return LatchMessage.release(Set.of("id-1"), ANNA).toJson();
    }

    private static List<byte[]> presences() {
        Presence online = new Presence(Presence.State.ONLINE, ANNA, "MAJIC 2.1", List.of(1, 3));
        return List.of(online.toJson(), online.ended(Presence.State.BROKEN).toJson());
    }

    private static Description description() {
        Parameter pan = Parameter.number("headPan", Unit.DEG, "left positive")
                .within(-91, 91)
                .with(Parameter.number("time", Unit.S, "how long"))
                .access(true, true, true);
        return new Description(
                "s-2",
                "Rex",
                new Description.Kind("aibo", "Aibo", "Sony Aibo"),
                "a Sony Aibo",
                new BotProfile(250, new Range(-1500, 1500), Range.ANY, 20, 10, 300, 60, 400, false),
                true,
                List.of("posture"),
                List.of(pan, Parameter.choice("posture", List.of("stand", "sit"), "how it stands")),
                List.of(new BotCommand("wag", List.of(pan), List.of(pan), true, "wags", false)),
                List.of(RangeSensor.laser(Pose.START, 3, -1, 1, 8000, 10)));
    }

    private static RobotState state(boolean connected) {
        return new RobotState(
                5,
                connected
                        ? new RobotState.Link(Connection.CONNECTED, "")
                        : new RobotState.Link(Connection.LOST, "cable pulled"),
                new RobotState.Movement(new Pose(1, 2, 3), new Pose(10, 20, 30), true, 4, 5, true, 6),
                true,
                3,
                connected ? new RobotState.Holder("desk1", "Anna", "0123456789abcdef", "WanderDog") : null,
                connected ? null : "not confirmed within 0.8 s",
                Map.of(
                        "voltage", ValueJson.of(Value.about(12.6, Unit.V)),
                        "sonar", ValueJson.of(Value.many(List.of(Value.of(300, Unit.MM), Value.CLEAR))),
                        "bumped", ValueJson.of(Value.yesNo(true)),
                        "gripper", ValueJson.of(Value.unknown("no reading yet"))));
    }

    private static List<byte[]> changes() {
        StateChange moved = new StateChange(
                6,
                0,
                new RobotState.Course(new Pose(1, 2, 3), new Pose(10, 20, 30), 100, -5),
                Map.of("bumped", ValueJson.of(Value.yesNo(true))));
        return List.of(moved.toJson(), new StateChange(7, 0, null, Map.of()).toJson());
    }

    private static List<byte[]> requests() {
        return Stream.of(
                        new RequestedAction.Move(-300.5, "distanceFront < 300 mm"),
                        new RequestedAction.Turn(90, ""),
                        new RequestedAction.Drive(200, -10, 2.5, "bumped"),
                        new RequestedAction.GoTo(new Pose(1500, -300, 90), true, "bumped"),
                        new RequestedAction.GoTo(new Pose(1500, -300, 0), false, ""),
                        new RequestedAction.Get("voltage"),
                        new RequestedAction.Set("headPan", List.of(Value.of(30, Unit.NONE), Value.text("500ms"))),
                        new RequestedAction.Run("wag", List.of(Value.yesNo(true))),
                        new RequestedAction.Hold(),
                        new RequestedAction.Free(),
                        new RequestedAction.Picture(),
                        new RequestedAction.Scans(),
                        new RequestedAction.Localize())
                .map(action -> new Request(ANNA, 17, OptionalLong.of(4711), action).toJson())
                .toList();
    }

    private static List<byte[]> replies() {
        return List.of(
                RequestReply.of(RequestReply.Outcome.REFUSED, "1 is held by Bob at desk3")
                        .toJson(),
                RequestReply.done(new MotionReport(Value.about(498, Unit.MM), 2.125))
                        .toJson(),
                RequestReply.done(Value.of(12.5, Unit.V)).toJson(),
                RequestReply.done("wagged").toJson());
    }

    private static List<String> names() {
        return List.copyOf(messages().keySet());
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyFieldThatIsWrittenIsInTheSchema(String name) throws IOException {
        JsonNode document = document(name);
        closeObjects(document);
        JsonSchema schema = schema(document);

        for (byte[] message : messages().getOrDefault(name, List.of())) {
            assertThat(schema.validate(MAPPER.readTree(message)))
                    .as(new String(message, java.nio.charset.StandardCharsets.UTF_8))
                    .isEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void aMessageWithoutARequiredFieldIsWrong(String name) throws IOException {
        JsonNode document = document(name);
        JsonSchema schema = schema(document);
        JsonNode required = document.path("required");
        assertThat(required).isNotEmpty();

        for (JsonNode field : required) {
            ObjectNode message =
                    (ObjectNode) MAPPER.readTree(messages().get(name).get(0));
            message.remove(field.asText());
            assertThat(schema.validate(message)).as(field.asText()).isNotEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "{\"session\":\"s\",\"number\":0,\"do\":\"hold\"}",
                "{\"session\":\"a b\",\"number\":1,\"do\":\"hold\"}",
                "{\"session\":\"s\",\"number\":1,\"do\":\"fly\"}",
                "{\"session\":\"s\",\"number\":1,\"do\":\"move\"}",
                "{\"session\":\"s\",\"number\":1,\"do\":\"move\",\"mm\":\"5\"}",
                "{\"session\":\"s\",\"desk\":\"/\",\"number\":1,\"do\":\"hold\"}"
            })
    void theSchemaRefusesTheRequestsThatADeskRefuses(String request) throws IOException {
        assertThat(schema(document("request")).validate(MAPPER.readTree(request)))
                .isNotEmpty();
    }

    @Test
    void fieldsOfANewerVersionAreAllowed() throws IOException {
        Set<ValidationMessage> mistakes =
                schema(document("hold")).validate(MAPPER.readTree("{\"session\":\"s\",\"validUntil\":1,\"mood\":[1]}"));

        assertThat(mistakes).isEmpty();
    }

    @Test
    void thereIsOneSchemaForEachKindOfMessage() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            assertThat(files.map(file -> file.getFileName().toString().replace(".schema.json", "")))
                    .containsExactlyInAnyOrderElementsOf(names());
        }
    }

    private static JsonNode document(String name) throws IOException {
        return MAPPER.readTree(FOLDER.resolve(name + ".schema.json").toFile());
    }

    private static JsonSchema schema(JsonNode document) {
        return JsonSchemaFactory.getInstance(VersionFlag.V202012).getSchema(document);
    }

    /** Forbids fields that the schema does not describe. */
    private static void closeObjects(JsonNode part) {
        if (part.has("properties") && part.path("type").asText().equals("object")) {
            ((ObjectNode) part).put("additionalProperties", false);
        }
        part.forEach(SchemasTest::closeObjects);
    }
}
