package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.team.QueuedCommand;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests shared robots as vehicles of VDA 5050: what fleet tools see of them, and that they can stop them. */
class FleetVehicleTest {
    private static final String VEHICLE = "lab/uagv/v2/MAJIC/desk7-1/";

    @AutoClose
    private final SharingRig rig = new SharingRig();

    private final FakeBot bot = rig.add();

    @AutoClose
    private final DeskSharing sharing =
            new DeskSharing(rig.team, new DeskOptions("lab", "desk7", "Bob", "MAJIC test", Set.of(), true), rig::open);

    @BeforeEach
    void share() {
        sharing.start();
        rig.clock.until(() -> !rig.broker.published(VEHICLE + "factsheet").isEmpty()
                && !rig.broker.published(VEHICLE + "state").isEmpty());
    }

    private static JsonNode json(BrokerMessage message) {
        try {
            return new ObjectMapper().readTree(message.payload());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private JsonNode kept(String topic) {
        return json(rig.broker.retained(VEHICLE + topic).orElseThrow());
    }

    private JsonNode state() {
        List<BrokerMessage> all = rig.broker.published(VEHICLE + "state");
        return json(all.get(all.size() - 1));
    }

    private void demand(String id, String type) {
        demand("{\"headerId\":1,\"actions\":[{\"actionId\":\"" + id + "\",\"actionType\":\"" + type
                + "\",\"blockingType\":\"HARD\"}]}");
    }

    private void demand(String payload) {
        rig.broker.publish(BrokerMessage.json(VEHICLE + "instantActions", payload, Quality.AT_MOST_ONCE));
    }

    private void statusOf(String id, String status) {
        rig.clock.until(() -> findAction(id).path("actionStatus").asText().equals(status));
    }

    private JsonNode findAction(String id) {
        for (JsonNode action : state().path("actionStates")) {
            if (action.path("actionId").asText().equals(id)) {
                return action;
            }
        }
        return new ObjectMapper().createObjectNode();
    }

    private void move() {
        rig.team.member(1).submit(new QueuedCommand("move 900", true, robot -> List.of("" + robot.move(900))), null);
        rig.clock.until(() -> bot.state().moving());
    }

    @Test
    void aVehicleIsOnlineAndBrokenByTheLastWillOfItsOwnConnection() {
        assertThat(kept("connection").path("connectionState").asText()).isEqualTo("ONLINE");

        vehicleConnection().kill();

        assertThat(kept("connection").path("connectionState").asText()).isEqualTo("CONNECTIONBROKEN");
    }

    private FakeConnection vehicleConnection() {
        return rig.connections.get(rig.connections.size() - 1);
    }

    @Test
    void aVehicleGoesOfflineWithItsDesk() {
        sharing.close();

        assertThat(kept("connection").path("connectionState").asText()).isEqualTo("OFFLINE");
    }

    @Test
    void aStateHasTheFieldsThatTheSpecificationDemands() {
        assertThat(state().fieldNames())
                .toIterable()
                .contains(
                        "headerId",
                        "timestamp",
                        "version",
                        "manufacturer",
                        "serialNumber",
                        "orderId",
                        "orderUpdateId",
                        "lastNodeId",
                        "lastNodeSequenceId",
                        "nodeStates",
                        "edgeStates",
                        "driving",
                        "actionStates",
                        "batteryState",
                        "operatingMode",
                        "errors",
                        "safetyState");
        assertThat(Instant.parse(state().path("timestamp").asText()))
                .isBefore(Instant.now().plusSeconds(5));
        assertThat(state().path("serialNumber").asText()).isEqualTo("desk7-1");
        assertThat(state().path("batteryState").path("batteryVoltage").asDouble())
                .isEqualTo(12.6);
        assertThat(state().path("information").path(0).path("infoType").asText())
                .isEqualTo("batteryChargeUnknown");
    }

    @Test
    void positionsAreInMetresAndRadians() {
        bot.place(new Pose(1500, -250, 270));
        demand("now", "stateRequest");
        statusOf("now", "FINISHED");

        JsonNode position = state().path("agvPosition");
        assertThat(position.path("x").asDouble()).isEqualTo(1.5);
        assertThat(position.path("y").asDouble()).isEqualTo(-0.25);
        assertThat(position.path("theta").asDouble()).isCloseTo(-Math.PI / 2, Offset.offset(1e-9));
        assertThat(position.path("positionInitialized").asBoolean()).isTrue();
        assertThat(position.path("mapId").asText()).isEqualTo("desk7");
    }

    @Test
    void messagesOfATopicAreCounted() {
        rig.sleep(25);

        assertThatStatesAreCounted();
        assertThat(rig.broker.published(VEHICLE + "state")).hasSizeBetween(3, 6);
    }

    @Test
    void aStateThatCannotBeSentIsNotCounted() {
        int before = rig.broker.published(VEHICLE + "state").size();
        rig.broker.stop();
        rig.clock.until(() -> !vehicleConnection().isConnected());
        rig.sleep(30);
        rig.broker.start();
        rig.clock.until(() -> rig.broker.published(VEHICLE + "state").size() > before);

        assertThatStatesAreCounted();
    }

    private void assertThatStatesAreCounted() {
        List<BrokerMessage> states = rig.broker.published(VEHICLE + "state");
        for (int n = 0; n < states.size(); n++) {
            assertThat(json(states.get(n)).path("headerId").asInt()).isEqualTo(n);
        }
    }

    @Test
    void aChangeIsReportedAtOnce() {
        move();
        rig.sleep(0.15);
        assertThat(state().path("driving").asBoolean()).isTrue();

        rig.team.stopAll();
        rig.sleep(0.15);
        assertThat(state().path("safetyState").path("eStop").asText()).isEqualTo("REMOTE");

        bot.cut();
        rig.sleep(0.15);
        assertThat(state().path("errors").path(0).path("errorType").asText()).isEqualTo("connectionLost");
        assertThat(state().has("agvPosition")).as("an old position").isFalse();
        assertThat(state().has("velocity")).as("an old velocity").isFalse();
    }

    @Test
    void startPauseAndCancelOrderStopTheRobot() {
        move();
        demand("p1", "startPause");
        statusOf("p1", "FINISHED");
        assertThat(bot.sent()).contains("halt");
        rig.clock.until(() -> rig.isSaid("1: stopped by fleet control (VDA 5050)"));

        move();
        long halts = bot.count("halt");
        demand("c1", "cancelOrder");
        statusOf("c1", "FINISHED");
        assertThat(bot.count("halt")).isGreaterThan(halts);
    }

    @Test
    void aStopThatTheRobotDoesNotConfirmHasFailed() {
        bot.getStuck();
        demand("p2", "startPause");

        statusOf("p2", "FAILED");
        assertThat(findAction("p2").path("resultDescription").asText()).contains("takes no more data");
        assertThat(state().path("errors").path(0).path("errorType").asText()).isEqualTo("stopNotConfirmed");
        bot.comeLoose();
    }

    @Test
    void anActionIsCarriedOutOnce() {
        demand("p3", "startPause");
        statusOf("p3", "FINISHED");
        move();
        demand("p3", "startPause");
        rig.sleep(0.5);

        assertThat(bot.state().moving()).isTrue();
    }

    @Test
    void otherActionsFailWithAReason() {
        demand("r1", "stopPause");
        demand("l1", "pick");

        statusOf("r1", "FAILED");
        statusOf("l1", "FAILED");
        assertThat(findAction("r1").path("resultDescription").asText()).startsWith("nothing resumes by itself");
        assertThat(findAction("l1").path("resultDescription").asText()).isEqualTo("pick is not supported");
    }

    @Test
    void aFactsheetIsSentAgainOnRequest() {
        int before = rig.broker.published(VEHICLE + "factsheet").size();
        demand("f1", "factsheetRequest");
        statusOf("f1", "FINISHED");

        assertThat(rig.broker.published(VEHICLE + "factsheet")).hasSize(before + 1);
        assertThat(kept("factsheet").fieldNames())
                .toIterable()
                .contains(
                        "typeSpecification",
                        "physicalParameters",
                        "protocolLimits",
                        "protocolFeatures",
                        "agvGeometry",
                        "loadSpecification");
        assertThat(kept("factsheet").path("physicalParameters").path("speedMax").asDouble())
                .isEqualTo(1);
    }

    @Test
    void ordersAndWhatCannotBeReadAreRejectedInTheState() {
        rig.broker.publish(BrokerMessage.json(VEHICLE + "order", "{\"orderId\":\"o\"}", Quality.AT_MOST_ONCE));
        rig.clock.until(
                () -> state().path("errors").path(0).path("errorType").asText().equals("orderError"));

        demand("{\"actions\":7}");
        rig.clock.until(
                () -> state().path("errors").path(0).path("errorType").asText().equals("validationError"));
        demand("[".repeat(5000));
        demand("ok", "stateRequest");
        statusOf("ok", "FINISHED");
        assertThat(state().path("errors")).isEmpty();
    }

    @Test
    void aVehicleIsPublishedAgainWhenTheBrokerIsBack() {
        rig.broker.stop();
        rig.broker.forget();
        rig.clock.until(() -> !vehicleConnection().isConnected());
        rig.broker.start();

        rig.clock.until(() -> rig.broker.retained(VEHICLE + "connection").isPresent());
        assertThat(kept("connection").path("connectionState").asText()).isEqualTo("ONLINE");
        assertThat(rig.broker.retained(VEHICLE + "factsheet")).isPresent();
    }

    @Test
    void withoutTheOptionNoVehicleIsPublished() {
        rig.sharing.start();
        rig.sleep(2);

        assertThat(rig.broker.published("lab/uagv/v2/MAJIC/desk2-1/#")).isEmpty();
    }
}
