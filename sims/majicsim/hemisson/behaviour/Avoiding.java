package majicsim.hemisson.behaviour;

import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.SensorTables;

/** Drives ahead and turns away from what is near in front or beside it; that side's LED is lit. */
final class Avoiding implements Behaviour {
    /** As in the factory firmware (sheet 6). */
    private static final int NEAR = 20;

    private static final int AHEAD = 5;
    private static final int FRONT = 0;
    private static final int FRONT_RIGHT = 1;
    private static final int FRONT_LEFT = 2;
    private static final int RIGHT = 3;
    private static final int LEFT = 4;

    private final Motors motors;
    private final HemissonBoard board;
    private final SensorTables infraRed;

    Avoiding(Motors motors, HemissonBoard board, SensorTables infraRed) {
        this.motors = motors;
        this.board = board;
        this.infraRed = infraRed;
    }

    @Override
    public void sensorsRead() {
        int right = Math.max(infraRed.proximity(FRONT_RIGHT), infraRed.proximity(RIGHT));
        int left = Math.max(infraRed.proximity(FRONT_LEFT), infraRed.proximity(LEFT));
        boolean near = Math.max(infraRed.proximity(FRONT), Math.max(left, right)) > NEAR;
        boolean turnRight = near && left > right;
        motors.set(near && !turnRight ? -AHEAD : AHEAD, turnRight ? -AHEAD : AHEAD);
        board.leds[HemissonBoard.FRONT_LEFT] = turnRight;
        board.leds[HemissonBoard.FRONT_RIGHT] = near && !turnRight;
    }
}
