package majic.hemisson.line;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;

/**
 * The commands that were sent and not answered, and what may be sent behind them without deafening the robot if the
 * line delivers all of them together. The receiver holds two characters while the robot answers; a third one deafens it
 * (Hemisson sheet 4.4). Some commands are answered so briefly that any command survives behind them
 * ({@link ReceiverLimits}). Guarded by its owner.
 */
final class UnansweredCommands {
    private static final int RECEIVER_HOLDS = 2;

    private final Deque<Sent> commands = new ArrayDeque<>();
    private final long stallNanos;
    private ReceiverLimits receiver = ReceiverLimits.UNKNOWN;
    private long lastSentNanos;

    private record Sent(Question question, String text, boolean brief) {
        /** The CR included. */
        int characters() {
            return text.length() + 1;
        }
    }

    UnansweredCommands(double stallSeconds) {
        stallNanos = (long) (stallSeconds * 1e9);
    }

    /** Sets what the robot's receiver survives. */
    void receiver(ReceiverLimits known) {
        receiver = known;
    }

    /**
     * How a question is sent now.
     *
     * @param mayMove whether the robot may move; a question then carries the arguments of a stop, if the robot ignores
     *     them
     */
    String wording(Question question, boolean mayMove) {
        if (question == Question.STOP && lastCarriesAStop()) {
            return Question.BRIEF_STOP;
        }
        boolean carries = question.canCarryAStop() && mayMove && receiver.ignoresArguments();
        return carries ? question.carryingAStop() : question.text();
    }

    /** Whether a command may be sent now. Commands that the line has held longer than it can stall count as lost. */
    boolean admits(String text, long nowNanos) {
        return nowNanos - lastSentNanos >= stallNanos || waitingBehindAnAnswer(text.length() + 1) <= RECEIVER_HOLDS;
    }

    private int waitingBehindAnAnswer(int added) {
        int characters = 0;
        boolean answering = false;
        for (Sent sent : commands) {
            characters += answering ? sent.characters() : 0;
            answering |= !sent.brief();
        }
        return answering ? characters + added : 0;
    }

    /** Whether the last one carries the arguments of a stop, so that a D without any is one (sheet 4.2). */
    private boolean lastCarriesAStop() {
        Sent last = commands.peekLast();
        return last != null && last.text().equals(last.question().carryingAStop());
    }

    void sent(Question question, String text, long nowNanos) {
        if (!admits(text, nowNanos)) {
            throw new IllegalStateException(text + " could deafen the robot");
        }
        if (nowNanos - lastSentNanos >= stallNanos) {
            commands.clear();
        }
        commands.addLast(new Sent(question, text, receiver.readsBehindBriefAnswers() && question.isAnsweredBriefly()));
        lastSentNanos = nowNanos;
    }

    /** Records an answer: commands sent before the answered one have been read as well. */
    void answered(Reply reply) {
        if (commands.stream().noneMatch(sent -> sent.question().isAnsweredBy(reply))) {
            damagedAnswer();
            return;
        }
        Iterator<Sent> oldest = commands.iterator();
        boolean found = false;
        while (!found) {
            found = oldest.next().question().isAnsweredBy(reply);
            oldest.remove();
        }
    }

    /** Records a line that matches no command, a refusal or a damaged answer; it counts for the oldest command. */
    void damagedAnswer() {
        commands.pollFirst();
    }

    /** Removes all, after a reset of the robot. */
    void clear() {
        commands.clear();
    }
}
