package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class VelocityFormTest {
    @Test
    void aVelocityIsSentInMetresAndRadians() {
        assertThat(VelocityForm.TWIST.message(-150, 180).toString())
                .isEqualTo("{\"linear\":{\"x\":-0.15,\"y\":0.0,\"z\":0.0},"
                        + "\"angular\":{\"x\":0.0,\"y\":0.0,\"z\":3.141592653589793}}");
    }

    @Test
    void aStampedVelocityHasAHeaderWithoutStampSoThatTheBridgeAddsTheTimeOfTheRobot() {
        assertThat(VelocityForm.TWIST_STAMPED.message(0, 0).toString())
                .isEqualTo("{\"header\":{},\"twist\":{\"linear\":{\"x\":0.0,\"y\":0.0,\"z\":0.0},"
                        + "\"angular\":{\"x\":0.0,\"y\":0.0,\"z\":0.0}}}");
    }

    @Test
    void aStopHasNoNegativeZero() {
        assertThat(VelocityForm.TWIST.message(-0.0, -0.0).toString()).doesNotContain("-");
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void aVelocityThatIsNotFiniteIsNeverMadeIntoAMessage(double wrong) {
        for (VelocityForm form : VelocityForm.values()) {
            assertThatThrownBy(() -> form.message(wrong, 0)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> form.message(0, wrong)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "geometry_msgs/Twist, TWIST",
        "geometry_msgs/msg/Twist, TWIST",
        "geometry_msgs/TwistStamped, TWIST_STAMPED",
        "geometry_msgs/msg/TwistStamped, TWIST_STAMPED"
    })
    void theTypeOfTheTopicDecidesTheForm(String type, VelocityForm form) {
        assertThat(VelocityForm.ofType(type)).contains(form);
        assertThat(VelocityForm.ofType(type + "WithCovariance")).isEmpty();
    }
}
