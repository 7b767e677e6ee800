package majicsim.hemisson.behaviour;

import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.SensorTables;

/**
 * Searches for black tape straight ahead, then keeps both ground sensors over it; off the tape it turns to the side of
 * the last detection.
 */
final class LineFollowing implements Behaviour {
    private static final int BLACK_BELOW = 90;
    private static final int AHEAD = 3;
    private static final int GROUND_RIGHT = 6;
    private static final int GROUND_LEFT = 7;

    private final Motors motors;
    private final HemissonBoard board;
    private final SensorTables infraRed;
    private boolean found;
    private boolean lastOnRight;

    LineFollowing(Motors motors, HemissonBoard board, SensorTables infraRed) {
        this.motors = motors;
        this.board = board;
        this.infraRed = infraRed;
    }

    @Override
    public void begin() {
        found = false;
    }

    @Override
    public void sensorsRead() {
        boolean right = infraRed.proximity(GROUND_RIGHT) < BLACK_BELOW;
        boolean left = infraRed.proximity(GROUND_LEFT) < BLACK_BELOW;
        found |= right || left;
        lastOnRight = right == left ? lastOnRight : right;
        board.leds[HemissonBoard.FRONT_LEFT] = left;
        board.leds[HemissonBoard.FRONT_RIGHT] = right;
        if (!found || right && left) {
            motors.set(AHEAD, AHEAD);
        } else {
            int inner = right || left ? 0 : -AHEAD;
            motors.set(lastOnRight ? AHEAD : inner, lastOnRight ? inner : AHEAD);
        }
    }
}
