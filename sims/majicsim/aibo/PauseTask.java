package majicsim.aibo;

/** Waits; it ends at the first cycle after its time. */
final class PauseTask extends Task {
    private final double ms;

    PauseTask(Context context, Value ms) throws Failure {
        super(context);
        this.ms = Operators.number(ms);
    }

    @Override
    protected boolean advance() {
        return elapsedMs() >= ms;
    }
}
