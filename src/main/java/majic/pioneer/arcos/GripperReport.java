package majic.pioneer.arcos;

/**
 * What gripper the robot has, and its switches (ARCOS sheet 11.5). Immutable.
 *
 * @param kind 1 on the user port, 2 on the general port, else none
 * @param switches bits, as the gripper's electronics have them
 * @param graspTime for how long the paddles press on after they touch, in 20 ms
 */
public record GripperReport(int kind, int switches, int graspTime) implements Report {
    static GripperReport read(FieldReader fields) {
        return new GripperReport(fields.ubyte(), fields.ubyte(), fields.ubyte());
    }
}
