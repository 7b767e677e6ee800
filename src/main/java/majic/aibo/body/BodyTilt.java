package majic.aibo.body;

import java.util.Optional;

/**
 * The tilt of the dog, from the direction of gravity in its acceleration sensors; on its feet gravity is along z,
 * downwards (URBI sheet 13). Immutable.
 *
 * @param pitchDeg nose up positive, −90 to 90
 * @param rollDeg right side down positive, −180 to 180
 */
public record BodyTilt(double pitchDeg, double rollDeg) {
    /** Returns what the sensors report now; empty before the first report. */
    public static Optional<BodyTilt> of(SensorReadings senses) {
        Optional<Double> x = senses.number(Sensor.ACCEL_X);
        Optional<Double> y = senses.number(Sensor.ACCEL_Y);
        Optional<Double> z = senses.number(Sensor.ACCEL_Z);
        if (x.isEmpty() || y.isEmpty() || z.isEmpty()) {
            return Optional.empty();
        }
        double pitch = Math.atan2(-x.get(), Math.hypot(y.get(), z.get()));
        double roll = Math.atan2(y.get(), -z.get());
        return Optional.of(new BodyTilt(Math.toDegrees(pitch), Math.toDegrees(roll)));
    }
}
