package majic.figures;

import java.util.concurrent.atomic.AtomicBoolean;
import majic.team.Answer;
import majic.team.TeamListener;

/** Prints why the first command failed that did. */
final class FirstFailure implements TeamListener {
    private final AtomicBoolean printed = new AtomicBoolean();

    @Override
    public void answered(Answer answer) {
        if (answer.outcome() != Answer.Outcome.DONE && !printed.getAndSet(true)) {
            System.err.println(answer.text());
        }
    }
}
