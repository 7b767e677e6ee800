package majicsim.aibo.body;

import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Evaluator;
import majicsim.aibo.urbi.run.Functions;
import majicsim.aibo.urbi.run.Server;
import majicsim.aibo.urbi.run.Task;

/**
 * One walk or turn of a given time. The body moves from its first step on for exactly that time in an exact lab, and up
 * to two kernel cycles longer otherwise, as it was measured (URBI sheet, section 3); the command ends at the cycle
 * after.
 */
public final class GaitTask extends Task {
    private static final double STEP_MS = 2000;

    private final Gait gait;
    private final boolean turn;
    private final double durationMs;
    private final double cyclesPerMs;
    private boolean begun;

    GaitTask(Context context, Gait gait, boolean turn, double ms, double cycleMs) {
        super(context);
        this.gait = gait;
        this.turn = turn;
        double late = gait.noise().isExact() || ms == 0 ? 0 : gait.noise().uniform(0, 2 * Server.CYCLE_MS);
        durationMs = Math.abs(ms) + late;
        cyclesPerMs = Math.signum(ms) / Math.max(1, Math.abs(cycleMs));
    }

    /** {@code robot.walk} or {@code robot.turn} under the tag by which the stick's own functions stop it. */
    public static Functions.Lasting function(Gait gait, boolean turn) {
        String word = turn ? "turn" : "walk";
        return (context, arguments) -> {
            double ms = arguments.get(0).number();
            double cycleMs = new Evaluator(context).number("robot." + word + "speed");
            return new GaitTask(context, gait, turn, ms, cycleMs).under(word);
        };
    }

    /**
     * The gait of swalk and sturn: two seconds a step. The length of a step is not documented; here it is half a gait
     * cycle.
     */
    public static Functions.Lasting steps(Gait gait, boolean turn) {
        return (context, arguments) -> {
            double ms = arguments.get(0).number() * STEP_MS;
            return new GaitTask(context, gait, turn, ms, 2 * STEP_MS).under(turn ? "turn" : "walk");
        };
    }

    boolean isTurn() {
        return turn;
    }

    /** Gait cycles a millisecond, negative backward or clockwise. */
    double cyclesPerMs() {
        return cyclesPerMs;
    }

    /** The share of a lab step in which it moves. */
    double overlapMs(double fromMs, double stepMs) {
        double begin = Math.max(fromMs, startMs());
        double end = Math.min(fromMs + stepMs, startMs() + durationMs);
        return Math.max(0, end - begin);
    }

    @Override
    protected boolean advance() {
        if (!begun) {
            begun = true;
            gait.add(this);
        }
        boolean over = elapsedMs() >= durationMs;
        if (!over) {
            gait.swing(this, context.server().pass());
        }
        return over;
    }

    @Override
    protected void ended() {
        gait.remove(this);
    }

    @Override
    protected void halted(boolean frozen) {
        if (frozen) {
            gait.remove(this);
        } else if (begun) {
            gait.add(this);
        }
    }
}
