package majicsim.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HexFormat;
import java.util.List;
import majicsim.mavlink.message.Frame;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a vehicle sends: rates, parameters, texts, versions of MAVLink. */
class TelemetryTest {
    private final MavlinkStand rover = new MavlinkStand("rover+ready");

    @Test
    void withoutBeingAskedItSendsEverythingOnceASecond() {
        rover.pass(10.01);
        for (MessageType type : List.of(
                MessageType.HEARTBEAT,
                MessageType.SYS_STATUS,
                MessageType.ATTITUDE,
                MessageType.LOCAL_POSITION_NED,
                MessageType.GLOBAL_POSITION_INT,
                MessageType.GPS_RAW_INT,
                MessageType.VFR_HUD,
                MessageType.BATTERY_STATUS)) {
            assertThat(rover.all(type).size()).as(type.name()).isBetween(10, 11);
        }
        assertThat(rover.all(MessageType.EXTENDED_SYS_STATE)).isEmpty();
    }

    @Test
    void anIntervalIsObeyedAndTheUsualOneComesBack() {
        assertThat(rover.command(511, 30, 100_000)).isZero();
        rover.pass(5);
        assertThat(rover.all(MessageType.ATTITUDE)).hasSize(50);
        rover.command(511, 30, -1);
        rover.forget();
        rover.pass(5);
        assertThat(rover.all(MessageType.ATTITUDE)).isEmpty();
        rover.command(511, 30, 0);
        rover.pass(5);
        assertThat(rover.all(MessageType.ATTITUDE)).hasSize(5);
        assertThat(rover.command(511, 9999, 1000)).isEqualTo(2);
    }

    @Test
    void thereIsNoHomeBeforeTheFirstFixAndNoOffsetBeforeTheOrigin() {
        MavlinkStand cold = new MavlinkStand("rover");
        cold.command(512, 242);
        cold.pass(5);
        assertThat(cold.all(MessageType.HOME_POSITION)).isEmpty();

        cold.pass(10);
        Message first = cold.ask(MessageType.HOME_POSITION);
        assertThat(first.number("x")).isNaN();
        assertThat(first.number("q", 0)).isNaN();

        cold.pass(30);
        Message later = cold.ask(MessageType.HOME_POSITION);
        assertThat(later.number("x")).isFinite();
        assertThat(later.number("q", 3)).isNaN();
    }

    @Test
    void aMessageCanBeAskedForOnce() {
        Message version = rover.ask(MessageType.AUTOPILOT_VERSION);
        assertThat(version.integer("capabilities") & (1 << 7 | 1 << 13)).isEqualTo(1 << 7 | 1 << 13);
        assertThat(version.integer("flight_sw_version")).isEqualTo(0x040600FF);
        rover.pass(3);
        assertThat(rover.all(MessageType.AUTOPILOT_VERSION)).hasSize(1);
        assertThat(rover.command(512, 9999)).isEqualTo(4);
    }

    @Test
    void aStreamOfTheOldKindIsNotAnswered() {
        int before = rover.received();
        rover.send(new Message(MessageType.REQUEST_DATA_STREAM)
                .with("target_system", 1)
                .with("req_stream_id", 10)
                .with("req_message_rate", 4)
                .with("start_stop", 1));
        assertThat(rover.received()).isEqualTo(before);
        rover.pass(5);
        assertThat(rover.all(MessageType.ATTITUDE)).hasSize(20);
        assertThat(rover.all(MessageType.VFR_HUD).size()).isBetween(4, 5);
    }

    @ParameterizedTest
    @CsvSource({
        "FS_GCS_ENABLE, 0",
        "FS_GCS_TIMEOUT, 5",
        "FS_TIMEOUT, 1.5",
        "FS_ACTION, 2",
        "WP_SPEED, 2",
        "CRUISE_SPEED, 2",
        "SYSID_THISMAV, 1",
        "SYSID_MYGCS, 255",
        "RC_OVERRIDE_TIME, 3"
    })
    void aParameterIsReadByItsName(String name, double value) {
        read(name);
        Message answer = rover.last(MessageType.PARAM_VALUE);
        assertThat(answer.text("param_id")).isEqualTo(name);
        assertThat(answer.number("param_value")).isEqualTo(value);
        assertThat(answer.integer("param_index")).isEqualTo(65_535);
    }

    private void read(String name) {
        rover.send(new Message(MessageType.PARAM_REQUEST_READ)
                .with("target_system", 1)
                .with("param_index", -1)
                .with("param_id", name));
    }

    @Test
    void anUnknownParameterIsNeverAnswered() {
        read("NO_SUCH");
        rover.set("NO_SUCH", 2);
        rover.pass(5);
        assertThat(rover.all(MessageType.PARAM_VALUE)).isEmpty();
    }

    @Test
    void aParameterIsSetAndSentBack() {
        rover.set("WP_SPEED", 1.25);
        assertThat(rover.last(MessageType.PARAM_VALUE).number("param_value")).isEqualTo(1.25);
        rover.set("FS_GCS_ENABLE", 1.2);
        assertThat(rover.last(MessageType.PARAM_VALUE).number("param_value")).isEqualTo(1);
    }

    @Test
    void allParametersAreListedWithTheirIndexes() {
        rover.send(new Message(MessageType.PARAM_REQUEST_LIST).with("target_system", 1));
        rover.pass(1);
        List<Message> list = rover.all(MessageType.PARAM_VALUE);
        assertThat(list).hasSizeGreaterThan(60).hasSize(list.get(0).integer("param_count"));
        assertThat(list.get(7).integer("param_index")).isEqualTo(7);
        assertThat(list.stream().map(value -> value.text("param_id"))).doesNotHaveDuplicates();
    }

    @Test
    void theVehicleTakesAnotherSystemId() {
        rover.set("SYSID_THISMAV", 7);
        rover.pass(1);
        assertThat(rover.frames().get(rover.received() - 1).system()).isEqualTo(7);
    }

    @Test
    void aLongTextComesInPiecesWithACommonId() {
        String text = "PreArm: ".repeat(14);
        rover.pass(0.1);
        rover.forget();
        rover.handling().say(4, text);
        rover.handling().say(4, "x".repeat(50));
        rover.pass(0.1);
        List<Message> pieces = rover.all(MessageType.STATUSTEXT);
        assertThat(pieces).hasSize(4);
        assertThat(pieces.get(0).text("text")
                        + pieces.get(1).text("text")
                        + pieces.get(2).text("text"))
                .isEqualTo(text);
        assertThat(pieces.get(2).integer("chunk_seq")).isEqualTo(2);
        assertThat(pieces.get(2).integer("id")).isNotZero();
        assertThat(pieces.get(3).integer("id")).isZero();
        assertThat(pieces.get(3).text("text")).hasSize(50);
    }

    @Test
    void theSequenceCountsAllFramesOfTheVehicle() {
        rover.pass(5);
        List<Frame> frames = rover.frames();
        for (int i = 1; i < frames.size(); i++) {
            assertThat(frames.get(i).sequence()).isEqualTo(frames.get(i - 1).sequence() + 1 & 0xFF);
        }
    }

    @Test
    void aVehicleOfVersion1SendsAndTakesThatOnly() {
        MavlinkStand old = new MavlinkStand("rover+ready+v1");
        old.command(511, 330, 100_000);
        old.pass(2);
        assertThat(old.frames())
                .isNotEmpty()
                .allSatisfy(frame -> assertThat(frame.version()).isEqualTo(1));
        assertThat(old.all(MessageType.OBSTACLE_DISTANCE)).isEmpty();
        assertThat(old.mode(MavlinkStand.GUIDED)).isZero();
        old.sendBytes(new Frame(
                        2,
                        0,
                        255,
                        190,
                        new Message(MessageType.COMMAND_LONG)
                                .with("command", 176)
                                .with("param1", 1)
                                .with("param2", 4))
                .toBytes());
        assertThat(old.handling().mode()).isEqualTo(MavlinkStand.GUIDED);
    }

    @Test
    void theFirstHeartbeatHasTheBytesOfArduRover() {
        rover.pass(0.004);
        byte[] frame = rover.frames().stream()
                .filter(one -> one.message().type() == MessageType.HEARTBEAT)
                .findFirst()
                .orElseThrow()
                .toBytes();
        assertThat(HexFormat.of().formatHex(frame)).matches("fd090000..0101000000" + "000000000a0341" + "0403....");
    }

    @ParameterizedTest
    @ValueSource(strings = {"rover+ready", "copter+ready"})
    void numbersThatAreNoneDoNoHarm(String model) {
        MavlinkStand stand = new MavlinkStand(model);
        stand.pass(0.1);
        stand.mode(model.startsWith("rover") ? 15 : 4);
        stand.arm();
        stand.command(22, 0, 0, 0, 0, 0, 0, 3);
        stand.pass(5);
        for (double number : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e30}) {
            for (int mask : new int[] {0x0DF8, 0x0DC7, 0x05C7, 0x05FF, 0x09FF, 0}) {
                Message target = MavlinkStand.target(MavlinkStand.FRAME_BODY, mask);
                for (String field : List.of("x", "y", "z", "vx", "vy", "vz", "yaw", "yaw_rate")) {
                    stand.send(target.with(field, number));
                    stand.pass(0.02);
                }
            }
            for (int command : new int[] {22, 178, 192, 400, 511, 512}) {
                stand.command(command, number, number, number, number, number, number, number);
                stand.send(new Message(MessageType.COMMAND_INT)
                        .with("command", command)
                        .with("param1", number)
                        .with("param2", 1)
                        .with("x", 1)
                        .with("z", number));
                stand.pass(0.02);
            }
            stand.send(new Message(MessageType.MISSION_ITEM)
                    .with("current", 2)
                    .with("command", 16)
                    .with("x", number)
                    .with("z", number));
            stand.set("ATC_ACCEL_MAX", Double.NaN);
            stand.pass(1);
        }
        assertThat(stand.mode(model.startsWith("rover") ? MavlinkStand.HOLD : 17))
                .isZero();
        stand.pass(1);
        assertThat(stand.last(MessageType.LOCAL_POSITION_NED).number("x")).isFinite();
        assertThat(stand.last(MessageType.LOCAL_POSITION_NED).number("z")).isFinite();
    }

    @Test
    void theModelIsReadFromWords() {
        assertThat(MavlinkOptions.parse("Rover,copter+ready+V1+udp=14551").vehicles())
                .containsExactly(
                        VehicleOptions.of(VehicleKind.ROVER), new VehicleOptions(VehicleKind.COPTER, true, 1, 14_551));
        assertThatThrownBy(() -> MavlinkOptions.parse("rover+fast"))
                .hasMessage("there is no 'fast' for a MAVLink vehicle; known are rover, boat or copter, then +ready +v1"
                        + " +udp=14550");
        assertThatThrownBy(() -> MavlinkOptions.parse("rover,plane")).hasMessageStartingWith("there is no 'plane'");
        assertThatThrownBy(() -> MavlinkOptions.parse("rover+udp=70000"))
                .hasMessage("udp must be a port from 1 to 65535, not 70000");
    }
}
