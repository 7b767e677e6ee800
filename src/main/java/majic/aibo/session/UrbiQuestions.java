package majic.aibo.session;

import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.driver.RobotWait;
import majic.time.WaitPolicy;

/** Asks the dog for single values and waits for the answers. Thread-safe. */
public final class UrbiQuestions {
    private final Tags tags;
    private final RobotWait waiting;

    UrbiQuestions(Tags tags, RobotWait waiting) {
        this.tags = tags;
        this.waiting = waiting;
    }

    /**
     * Asks for a value and blocks until it arrives.
     *
     * @param seconds the longest wait
     * @throws UrbiRefusal if the dog gives none, or the thread may not wait for it
     */
    public UrbiValue ask(UrbiConnection on, String expression, double seconds) {
        if (!WaitPolicy.isAllowed()) {
            throw new UrbiRefusal("the dog tells it only when asked");
        }
        UrbiRequest request = on.ask(tags, expression);
        waiting.await(() -> request.isDone() || on.isEnded(), seconds);
        on.forget(request);
        UrbiValue value = request.value();
        if (value == null) {
            String failure = request.failure();
            throw new UrbiRefusal(
                    failure == null
                            ? "the dog did not answer within " + seconds + " s"
                            : "the dog refuses: " + failure);
        }
        return value;
    }
}
