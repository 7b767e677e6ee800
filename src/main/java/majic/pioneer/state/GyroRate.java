package majic.pioneer.state;

import java.util.OptionalDouble;
import majic.pioneer.arcos.Gyro;

/**
 * Computes the turn rate from the samples of the gyro (ARCOS sheet 11.6: 512 is rest; 9.1: GyroScaler). The sheet has
 * neither scale nor sign; both are taken from ARIA: 300 deg/s are 2.5 V, 5 V are 1023 counts, and less is
 * counterclockwise. Not tested on a robot.
 */
final class GyroRate {
    private static final int REST = 512;

    /** GyroScaler, the same for every model. */
    private static final double SCALER = 1.626;

    private static final double DEG_PER_SEC_PER_COUNT = 5.0 / 1023 * 300 / 2.5 * SCALER;

    private GyroRate() {}

    /** The mean of a packet's samples, deg/s, counterclockwise positive; empty if it holds none. */
    static OptionalDouble degPerSec(Gyro gyro) {
        return gyro.samples().stream()
                .mapToDouble(sample -> (REST - sample.rate()) * DEG_PER_SEC_PER_COUNT)
                .average();
    }
}
