package majic.script.run;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** The questions of scripts that wait for an answer. Thread-safe. */
public final class Questions {
    private final Signal changes;
    private final TimeSource time;
    private final List<Question> open = new ArrayList<>();
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();

    /** A question of a script. */
    public static final class Question {
        private final String text;
        private final Parameter wanted;
        private final Value otherwise;
        private final TimeSource time;
        private final long asked;
        private final double seconds;
        private volatile @Nullable Value answer;

        Question(String text, Parameter wanted, Value otherwise, TimeSource time, double seconds) {
            this.text = text;
            this.wanted = wanted;
            this.otherwise = otherwise;
            this.time = time;
            this.asked = time.nanos();
            this.seconds = seconds;
        }

        /** The question as it is shown. */
        public String text() {
            return text;
        }

        /** What answers it may have. */
        public Parameter wanted() {
            return wanted;
        }

        /** The answer that is taken if none comes in time. */
        public Value otherwise() {
            return otherwise;
        }

        /** For how long an answer is still taken, seconds; not negative. */
        public double secondsLeft() {
            return Math.max(0, seconds - time.secondsSince(asked));
        }

        /** The answer; null while there is none. */
        public @Nullable Value answer() {
            return answer;
        }
    }

    /**
     * No question.
     *
     * @param changes is raised by an answer
     * @param time the clock of the scripts
     */
    public Questions(Signal changes, TimeSource time) {
        this.changes = changes;
        this.time = time;
    }

    /** Adds something that is called, on any thread, after a question has begun or ended. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** The questions that wait, the oldest one first. */
    public List<Question> open() {
        synchronized (open) {
            return List.copyOf(open);
        }
    }

    /** Asks a question, until it is {@link #close closed}. */
    Question ask(String text, Parameter wanted, Value otherwise, double seconds) {
        Question question = new Question(text, wanted, otherwise, time, seconds);
        synchronized (open) {
            open.add(question);
        }
        listeners.forEach(Runnable::run);
        return question;
    }

    /** Ends a question, with or without an answer. */
    void close(Question question) {
        synchronized (open) {
            open.remove(question);
        }
        listeners.forEach(Runnable::run);
    }

    /**
     * Answers the oldest question.
     *
     * @param value as it was written
     * @throws BotException if there is no question, or it cannot have that answer; the message says which it can have
     */
    public void answer(Value value) {
        synchronized (open) {
            Question question = open.stream()
                    .filter(one -> one.answer == null)
                    .findFirst()
                    .orElseThrow(() -> new BotException("answer: no script has asked a question"));
            question.answer = question.wanted.fit(value);
        }
        changes.raise();
    }
}
