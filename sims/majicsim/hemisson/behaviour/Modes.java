package majicsim.hemisson.behaviour;

import java.util.Map;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRed;
import majicsim.hemisson.board.Motors;

/** The running mode and what it does. */
public final class Modes {
    private static final Behaviour IDLE = new Behaviour() {};

    private final Map<RunMode, Behaviour> behaviours;
    private RunMode mode = RunMode.REMOTE;
    private Behaviour behaviour = IDLE;

    public Modes(Motors motors, HemissonBoard board, InfraRed infraRed) {
        behaviours = Map.of(
                RunMode.AVOIDING, new Avoiding(motors, board, infraRed),
                RunMode.LINE, new LineFollowing(motors, board, infraRed),
                RunMode.DANCE, new Dance(motors, board));
    }

    /** The processor starts and looks at the switches. */
    public void start(String switches) {
        mode = RunMode.of(switches);
        behaviour = behaviours.getOrDefault(mode, IDLE);
        behaviour.begin();
    }

    public RunMode mode() {
        return mode;
    }

    public Behaviour behaviour() {
        return behaviour;
    }
}
