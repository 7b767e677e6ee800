package majic.pioneer.state;

/**
 * The state of gripper and lift (ARCOS sheet 11.5: the state byte). Between two ends both flags are false. Immutable.
 *
 * @param open whether the paddles are all the way open
 * @param closed whether they are closed, on something or on each other
 * @param moving whether they move
 * @param liftUp whether the lift is all the way up
 * @param liftDown whether it is all the way down
 * @param liftMoving whether it moves
 */
public record Gripper(
        boolean open, boolean closed, boolean moving, boolean liftUp, boolean liftDown, boolean liftMoving) {

    static Gripper of(int stateByte) {
        return new Gripper(
                isSet(stateByte, 0),
                isSet(stateByte, 1),
                isSet(stateByte, 2),
                isSet(stateByte, 4),
                isSet(stateByte, 5),
                isSet(stateByte, 6));
    }

    private static boolean isSet(int bits, int bit) {
        return (bits >> bit & 1) != 0;
    }
}
