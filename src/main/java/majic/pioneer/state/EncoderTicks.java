package majic.pioneer.state;

import majic.pioneer.arcos.Encoders;

/**
 * The encoder counts of the wheels without the roll-over of the robot's 32 bits (ARCOS sheet 11.1). CONFIG's TICKSMM
 * has the ticks per mm. Immutable.
 *
 * @param left rising when moving ahead
 * @param right rising when moving ahead
 */
public record EncoderTicks(long left, long right) {

    /** These and the shorter way from one reading to the next. */
    EncoderTicks plus(Encoders before, Encoders now) {
        return new EncoderTicks(
                left + (now.leftTicks() - before.leftTicks()), right + (now.rightTicks() - before.rightTicks()));
    }
}
