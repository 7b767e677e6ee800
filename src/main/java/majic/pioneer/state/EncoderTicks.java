package majic.pioneer.state;

import majic.pioneer.arcos.Encoders;

/**
 * What the wheels' encoders count, going on where the robot's own 32 bits roll over (ARCOS sheet 11.1). CONFIG's TICKSMM
 * tells how many make a mm. Immutable.
 *
 * @param left ahead counts up
 * @param right ahead counts up
 */
public record EncoderTicks(long left, long right) {

    /** These and the shorter way from one reading to the next. */
    EncoderTicks plus(Encoders before, Encoders now) {
        return new EncoderTicks(
                left + (now.leftTicks() - before.leftTicks()), right + (now.rightTicks() - before.rightTicks()));
    }
}
