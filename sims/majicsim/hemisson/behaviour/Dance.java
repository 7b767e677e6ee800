package majicsim.hemisson.behaviour;

import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;

/** Swings to and fro, 0.9 s each way, at the speeds that the factory firmware was seen to set (sheet, appendix). */
final class Dance implements Behaviour {
    private static final double FIGURE_SECONDS = 0.9;

    private final Motors motors;
    private final HemissonBoard board;
    private double leftSeconds;
    private boolean back;

    Dance(Motors motors, HemissonBoard board) {
        this.motors = motors;
        this.board = board;
    }

    @Override
    public void begin() {
        back = true;
        leftSeconds = 0;
    }

    @Override
    public boolean isIdle() {
        return false;
    }

    @Override
    public void step(double seconds) {
        leftSeconds -= seconds;
        if (leftSeconds <= 0) {
            leftSeconds += FIGURE_SECONDS;
            back = !back;
            motors.set(back ? -5 : 10, back ? -10 : 5);
            board.leds[HemissonBoard.FRONT_LEFT] = back;
            board.leds[HemissonBoard.FRONT_RIGHT] = !back;
        }
    }
}
