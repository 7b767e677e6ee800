package majicsim.hemisson.behaviour;

import java.util.Map;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.SensorTables;

/** The running mode and what it does. */
public final class ActiveRunMode {
    private static final Behaviour IDLE = new Behaviour() {};

    private final Map<RunMode, Behaviour> behaviours;
    private RunMode mode = RunMode.REMOTE;
    private Behaviour behaviour = IDLE;

    public ActiveRunMode(Motors motors, HemissonBoard board, SensorTables infraRed) {
        behaviours = Map.of(
                RunMode.AVOIDING, new Avoiding(motors, board, infraRed),
                RunMode.LINE, new LineFollowing(motors, board, infraRed),
                RunMode.DANCE, new Dance(motors, board));
    }

    /** Starts the processor, which reads the switches. */
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
