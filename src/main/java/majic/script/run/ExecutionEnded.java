package majic.script.run;

import majic.team.Answer;

/** A script cannot go on: something in it failed, or it was stopped. The message is the reason, as half a sentence. */
public final class ExecutionEnded extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final Answer.Outcome outcome;

    public ExecutionEnded(Answer.Outcome outcome, String message) {
        super(message, null, false, false);
        this.outcome = outcome;
    }

    public Answer.Outcome outcome() {
        return outcome;
    }

    /** The words in answers. */
    public String ending() {
        return outcome == Answer.Outcome.STOPPED ? "stopped" : "failed: " + getMessage();
    }
}
