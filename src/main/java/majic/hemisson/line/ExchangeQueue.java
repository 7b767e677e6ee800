package majic.hemisson.line;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.jspecify.annotations.Nullable;

/** The questions that wait to be sent. Guarded by its owner. */
final class ExchangeQueue {
    private final Deque<Exchange> waiting = new ArrayDeque<>();

    void add(Exchange exchange) {
        waiting.addLast(exchange);
    }

    /** Adds a question before all others. */
    void addFirst(Exchange exchange) {
        waiting.addFirst(exchange);
    }

    /** Adds a question again before all others except a stop. */
    void repeat(Exchange exchange) {
        Exchange first = waiting.peekFirst();
        if (first != null && first.isOfStop()) {
            waiting.removeFirst();
            waiting.addFirst(exchange);
            waiting.addFirst(first);
        } else {
            waiting.addFirst(exchange);
        }
    }

    /** Adds a stop before all others, and discards the motions. */
    void stop(Question how) {
        discard(Question.Purpose.MOTION, "stopped");
        if (!holds(how.purpose())) {
            addFirst(new Exchange(how));
        }
    }

    /**
     * Adds a stop behind the first question, and discards the motions. For a robot that always sets its own speeds, so
     * that other questions get through.
     */
    void stopBehindFirst(Question how) {
        discard(Question.Purpose.MOTION, "stopped");
        Exchange first = waiting.pollFirst();
        if (!holds(how.purpose())) {
            addFirst(new Exchange(how));
        }
        if (first != null) {
            addFirst(first);
        }
    }

    @Nullable
    Exchange first() {
        return waiting.peekFirst();
    }

    @Nullable
    Exchange next() {
        return waiting.pollFirst();
    }

    boolean holds(Question.Purpose purpose) {
        return waiting.stream().anyMatch(exchange -> exchange.purpose() == purpose);
    }

    /** Discards all questions with a purpose. */
    void discard(Question.Purpose purpose, String why) {
        for (Iterator<Exchange> all = waiting.iterator(); all.hasNext(); ) {
            Exchange exchange = all.next();
            if (exchange.purpose() == purpose) {
                all.remove();
                exchange.failed(why);
            }
        }
    }

    /** Discards all. */
    void discardAll(String why) {
        waiting.forEach(exchange -> exchange.failed(why));
        waiting.clear();
    }
}
