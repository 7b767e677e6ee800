package majic.mavlink.message;

import static org.assertj.core.api.Assertions.assertThatCode;

import com.code_intelligence.jazzer.junit.FuzzTest;
import majic.mavlink.frame.MavlinkMessageType;
import majic.mavlink.frame.Payload;

/** Arbitrary fields of messages: see CONTRIBUTING.md. */
class ReportsFuzzTest {
    @FuzzTest
    void anyFieldsMakeAMessage(byte[] fields) {
        assertThatCode(() -> read(fields)).doesNotThrowAnyException();
    }

    private static void read(byte[] fields) {
        VehicleHeartbeat.of(payload(fields, MavlinkMessageType.HEARTBEAT));
        AttitudeReport.of(payload(fields, MavlinkMessageType.ATTITUDE)).isUsable();
        LocalPosition.of(payload(fields, MavlinkMessageType.LOCAL_POSITION_NED)).isUsable();
        GlobalPosition.of(payload(fields, MavlinkMessageType.GLOBAL_POSITION_INT))
                .distanceMm(0, 0);
        GpsFix.of(payload(fields, MavlinkMessageType.GPS_RAW_INT)).title();
        BatteryReport.ofBattery(payload(fields, MavlinkMessageType.BATTERY_STATUS));
        BatteryReport.ofSystem(payload(fields, MavlinkMessageType.SYS_STATUS));
        CommandAck.of(payload(fields, MavlinkMessageType.COMMAND_ACK)).title();
        ParameterValue.of(payload(fields, MavlinkMessageType.PARAM_VALUE));
        StatusPiece.of(payload(fields, MavlinkMessageType.STATUSTEXT)).isLast();
        RangeReading.of(payload(fields, MavlinkMessageType.DISTANCE_SENSOR)).isHorizontal();
        ObstacleRing ring = ObstacleRing.of(payload(fields, MavlinkMessageType.OBSTACLE_DISTANCE));
        for (int index = 0; index < ObstacleRing.COUNT; index++) {
            ring.mm(index);
        }
    }

    private static Payload payload(byte[] fields, MavlinkMessageType type) {
        return new Payload(fields, type.fullLength());
    }
}
