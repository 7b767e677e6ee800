package majic.hemisson.readings;

import java.util.List;
import majic.hemisson.line.Identity;
import majic.hemisson.line.Question;
import org.jspecify.annotations.Nullable;

/**
 * Chooses the next question of the polls: mostly proximity, in between light, switches, the TV remote control and what
 * is polled on request. Used by one thread at a time.
 */
public final class PollSchedule {
    private static final int ROUND = 16;

    private final PolledAnswers polled;
    private int turn;
    private int nextRequested;

    public PollSchedule(PolledAnswers polled) {
        this.polled = polled;
    }

    /**
     * The next question.
     *
     * @param inMotion whether the robot may move; it is asked nothing then that takes long, and nothing that it might
     *     refuse, for that would count as a missed answer
     * @param identity whether it can be asked for the speeds of its wheels, and may set them itself
     */
    public Question next(long nowNanos, boolean inMotion, Identity identity) {
        turn = (turn + 1) % ROUND;
        if (inMotion && turn % 2 == 1 && identity.hasOwnSpeeds() && identity.tellsSpeeds()) {
            return Question.SPEEDS;
        }
        Question requested = turn % 4 == 1 ? requested(nowNanos, inMotion) : null;
        Question usual = requested == null ? usual(identity.tellsSpeeds()) : requested;
        boolean mightBeRefused = inMotion ? !polled.hasAnswered(usual) : polled.isRefused(usual);
        return mightBeRefused ? Question.PROXIMITY : usual;
    }

    /** Every other question is for proximity, so that a moving robot is polled for it every 100 ms. */
    private Question usual(boolean checksSpeeds) {
        return switch (turn) {
            case 3, 11 -> Question.LIGHT;
            case 5 -> Question.SWITCHES;
            case 13 -> Question.REMOTE;
            case 7, 15 -> checksSpeeds ? Question.SPEEDS : Question.PROXIMITY;
            default -> Question.PROXIMITY;
        };
    }

    private @Nullable Question requested(long nowNanos, boolean inMotion) {
        List<PolledQuestion> requested = polled.requested();
        if (requested.isEmpty()) {
            return null;
        }
        nextRequested = (nextRequested + 1) % requested.size();
        Question question = requested.get(nextRequested).next(nowNanos);
        return question == null || (inMotion && question.isLong()) ? null : question;
    }
}
