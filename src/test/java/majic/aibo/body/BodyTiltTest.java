package majic.aibo.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.aibo.urbi.UrbiValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BodyTiltTest {
    private final SensorReadings senses = new SensorReadings();

    @ParameterizedTest
    @CsvSource({"0, 0, -9.8, 0, 0", "-6.93, 0, -6.93, 45, 0", "0, 6.93, -6.93, 0, 45", "0, 0, 9.8, 0, 180"})
    void theTiltFollowsFromTheDirectionOfGravity(double x, double y, double z, double pitch, double roll) {
        put(Sensor.ACCEL_X, x);
        put(Sensor.ACCEL_Y, y);
        put(Sensor.ACCEL_Z, z);

        BodyTilt tilt = BodyTilt.of(senses).orElseThrow();

        assertThat(tilt.pitchDeg()).isCloseTo(pitch, within(0.01));
        assertThat(tilt.rollDeg()).isCloseTo(roll, within(0.01));
    }

    @Test
    void withoutReadingsThereIsNone() {
        put(Sensor.ACCEL_X, 0);

        assertThat(BodyTilt.of(senses)).isEmpty();
    }

    private void put(Sensor sensor, double amount) {
        senses.put(sensor, new UrbiValue.Num(amount), 0);
    }
}
