package majicsim.aibo.urbi.run;

import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/** A pause, which ends at the first cycle after its time. */
public final class PauseTask extends Task {
    private final double ms;

    PauseTask(Context context, double ms) {
        super(context);
        this.ms = ms;
    }

    /** Returns a pause of one cycle. */
    public static PauseTask cycle(Context context) {
        return new PauseTask(context, Double.MIN_VALUE);
    }

    public static PauseTask of(Context context, Value ms) throws Failure {
        if (ms instanceof Value.Num number) {
            return new PauseTask(context, number.number());
        }
        throw Failure.of("Invalid type. NUM expected.");
    }

    @Override
    protected boolean advance() {
        return elapsedMs() >= ms;
    }
}
