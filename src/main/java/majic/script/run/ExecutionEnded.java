package majic.script.run;

import majic.team.Answer;

/** A script cannot go on: something in it failed, or somebody stopped it. The message says why, as half a sentence. */
public final class ExecutionEnded extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final Answer.Outcome outcome;

    ExecutionEnded(Answer.Outcome outcome, String message) {
        super(message, null, false, false);
        this.outcome = outcome;
    }

    public Answer.Outcome outcome() {
        return outcome;
    }

    /** How answers tell it. */
    public String ending() {
        return outcome == Answer.Outcome.STOPPED ? "stopped" : "failed: " + getMessage();
    }
}
