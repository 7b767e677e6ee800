package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.node.ObjectNode;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OdometryMessageTest {
    @Test
    void aRecordedMessageIsRead() {
        OdometryMessage read = OdometryMessage.from(Recorded.message("/odom"));

        assertThat(read).isEqualTo(new OdometryMessage(Pose.START, 0, 0, "odom", "base_footprint"));
    }

    @Test
    void metresAndRadiansBecomeMillimetresAndDegrees() {
        ObjectNode message = moving(1.5, -0.25, Math.sin(Math.PI / 4), Math.cos(Math.PI / 4));

        OdometryMessage read = OdometryMessage.from(message);

        assertThat(read.pose().xMm()).isCloseTo(1500, within(1e-9));
        assertThat(read.pose().yMm()).isCloseTo(-250, within(1e-9));
        assertThat(read.pose().headingDeg()).isCloseTo(90, within(1e-9));
        assertThat(read.speedMmPerSec()).isCloseTo(200, within(1e-9));
        assertThat(read.turnRateDegPerSec()).isCloseTo(-180, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 0", "1, 0, 180", "-1, 1, -90", "0.2, 0.2, 90", "0, -1, 0", "0, 0, 0"})
    void theHeadingFollowsFromAQuaternionThatNeedNotBeNormalised(double z, double w, double headingDeg) {
        assertThat(OdometryMessage.from(moving(0, 0, z, w)).pose().headingDeg()).isCloseTo(headingDeg, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(strings = {"null", "'1'", "NaN", "true", "{}", "1e999"})
    void aPositionThatIsNoFiniteNumberIsRefused(String x) {
        ObjectNode message = moving(0, 0, 0, 1);
        ((ObjectNode) message.at("/pose/pose/position")).set("x", Recorded.json(x));

        assertThatThrownBy(() -> OdometryMessage.from(message))
                .isInstanceOf(UnusableMessage.class)
                .hasMessageStartingWith("pose.pose.position.x has to be a finite number, not ");
    }

    @Test
    void aMessageOfAnotherTypeIsRefused() {
        assertThatThrownBy(() -> OdometryMessage.from(Recorded.message("/scan")))
                .hasMessage("pose.pose.position.x has to be a finite number, not absent");
        assertThatThrownBy(() -> OdometryMessage.from(Recorded.json("[1]"))).isInstanceOf(UnusableMessage.class);
    }

    private static ObjectNode moving(double x, double y, double z, double w) {
        return (ObjectNode) Recorded.json(("{'header':{'frame_id':'/odom'},'child_frame_id':'base_link',"
                        + "'pose':{'pose':{'position':{'x':%s,'y':%s,'z':0},"
                        + "'orientation':{'x':0,'y':0,'z':%s,'w':%s}}},"
                        + "'twist':{'twist':{'linear':{'x':0.2,'y':-0.01},'angular':{'z':%s}}}}")
                .formatted(x, y, z, w, -Math.PI));
    }
}
