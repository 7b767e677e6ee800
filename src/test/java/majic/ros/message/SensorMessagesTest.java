package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.OptionalDouble;
import majic.ros.message.BatteryMessage.Supply;
import majic.ros.message.JointsMessage.JointReading;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SensorMessagesTest {
    @Test
    void aRecordedBatteryIsRead() {
        BatteryMessage battery = BatteryMessage.from(Recorded.message("/battery_state"));

        assertThat(battery.volts().getAsDouble()).isCloseTo(12.1, within(1e-6));
        assertThat(battery.percent().getAsDouble()).isCloseTo(73, within(1e-4));
        assertThat(battery.supply()).isEqualTo(Supply.UNKNOWN);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "0.5, 50",
        "1, 100",
        "1.13, 100",
        "1.5, 100",
        "1.6, 1.6",
        "50, 50",
        "100, 100",
        "104, 100",
        "-1, 0"
    })
    void aChargeIsAFractionOrAPercentageWhicheverTheRobotSends(double sent, double percent) {
        assertThat(BatteryMessage.from(Recorded.json("{'percentage':%s}".formatted(sent)))
                        .percent()
                        .getAsDouble())
                .isCloseTo(percent, within(1e-9));
    }

    @Test
    void aBatteryThatReportsNothingIsUnknownAndAnotherMessageIsRefused() {
        BatteryMessage battery =
                BatteryMessage.from(Recorded.json("{'voltage':null,'percentage':NaN,'power_supply_status':99}"));

        assertThat(battery)
                .isEqualTo(new BatteryMessage(OptionalDouble.empty(), OptionalDouble.empty(), Supply.UNKNOWN));
        assertThatThrownBy(() -> BatteryMessage.from(Recorded.message("/scan"))).isInstanceOf(UnusableMessage.class);
    }

    @ParameterizedTest
    @CsvSource({"0, DISCHARGING", "2, FULL", "6, CHARGING", "18, FULL", "22, CHARGING", "16, DISCHARGING", "4, UNKNOWN"
    })
    void theChargerOfAKobukiIsInTheLowerBits(int charger, Supply supply) {
        BatteryMessage battery =
                BatteryMessage.kobuki(Recorded.json("{'battery':161,'charger':%d}".formatted(charger)));

        assertThat(battery.supply()).isEqualTo(supply);
        assertThat(battery.percent()).isEmpty();
    }

    @Test
    void aSpotWithoutABatteryHasAnUnusableMessage() {
        assertThatThrownBy(() -> BatteryMessage.spot(Recorded.json("{'battery_states':[{'status':1}]}")))
                .isInstanceOf(UnusableMessage.class);
        assertThat(BatteryMessage.spot(Recorded.json("{'battery_states':[{'status':3,'charge_percentage':130}]}"))
                        .percent())
                .hasValue(100);
    }

    @ParameterizedTest
    @CsvSource({"0.5, 500", "0.1, 100", "4, 4000", "4.01, ", "0.05, ", "null, ", "Infinity, "})
    void aRangeIsKnownWithinTheLimitsOfTheSensor(String sent, Double mm) {
        RangeMessage range = RangeMessage.from(Recorded.json(
                "{'header':{'frame_id':'sonar'},'field_of_view':0.5,'min_range':0.1,'max_range':4,'range':%s}"
                        .formatted(sent)));

        assertThat(range.rangeMm()).isEqualTo(mm == null ? OptionalDouble.empty() : OptionalDouble.of(mm));
    }

    @Test
    void anInertialUnitWithoutOrientationHasOnlyRates() {
        ImuMessage imu = ImuMessage.from(Recorded.json("{'orientation':{'x':0,'y':0,'z':0,'w':1},"
                + "'orientation_covariance':[-1,0,0],'angular_velocity':{'x':0,'y':0,'z':0.5},"
                + "'linear_acceleration':{'x':null,'y':0,'z':9.8}}"));

        assertThat(imu.orientation()).isEmpty();
        assertThat(imu.ratesDegPerSec().orElseThrow().z()).isCloseTo(28.65, within(0.01));
        assertThat(imu.accelerations()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0.2588190451, 0, 30, 0", "0, 0.2588190451, 0, 30", "0, -0.7009092643, 0, -89"})
    void theTiltFollowsFromTheOrientation(double x, double y, double rollDeg, double pitchDeg) {
        double w = Math.sqrt(1 - x * x - y * y);
        Orientation tilted = ImuMessage.from(
                        Recorded.json("{'orientation':{'x':%s,'y':%s,'z':0,'w':%s}}".formatted(x, y, w)))
                .orientation()
                .orElseThrow();

        assertThat(tilted.rollDeg()).isCloseTo(rollDeg, within(1e-3));
        assertThat(tilted.pitchDeg()).isCloseTo(pitchDeg, within(1e-3));
    }

    @Test
    void jointsAreReadEvenIfTheMessageHasNoVelocities() {
        assertThat(JointsMessage.from(Recorded.message("/joint_states")).joints())
                .extracting(JointReading::name)
                .containsExactly("wheel_left_joint", "wheel_right_joint");
        assertThat(JointsMessage.from(Recorded.json("{'name':['arm'],'position':[1.5],'velocity':[]}"))
                        .joints())
                .containsExactly(new JointReading("arm", OptionalDouble.of(1.5), OptionalDouble.empty()));
    }

    @Test
    void aPictureComesInBase64OrInBytes() {
        byte[] inBase64 = CompressedPicture.from(Recorded.message("/camera/image/compressed"))
                .file();
        byte[] inBytes = CompressedPicture.from(JsonNodeFactory.instance
                        .objectNode()
                        .put("format", "png")
                        .put("data", new byte[] {1, 2}))
                .file();

        assertThat(inBase64).containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
        assertThat(inBytes).containsExactly(1, 2);
    }

    @ParameterizedTest
    @CsvSource({"'{}'", "'{\"data\":\"\"}'", "'{\"data\":\"#\"}'", "'{\"data\":[1,2]}'", "'{\"data\":null}'"})
    void aPictureWithoutBytesIsRefused(String message) {
        assertThatThrownBy(() -> CompressedPicture.from(Recorded.json(message))).isInstanceOf(UnusableMessage.class);
    }
}
