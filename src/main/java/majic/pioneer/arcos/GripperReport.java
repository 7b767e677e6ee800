package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/**
 * What gripper the robot has, and its switches (ARCOS sheet 11.5). Immutable.
 *
 * @param kind 1 on the user port, 2 on the general port, else none
 * @param switches bits, as the gripper's electronics have them
 * @param graspTime for how long the paddles press on after they touch, in 20 ms
 */
public record GripperReport(int kind, int switches, int graspTime) implements Report {
    static final int TYPE = 0xE0;
    private static final int BYTES = 3;

    static @Nullable GripperReport read(FieldReader fields) {
        return fields.remaining() < BYTES ? null : new GripperReport(fields.ubyte(), fields.ubyte(), fields.ubyte());
    }
}
