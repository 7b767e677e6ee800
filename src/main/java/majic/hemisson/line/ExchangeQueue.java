package majic.hemisson.line;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import org.jspecify.annotations.Nullable;

/** The questions that wait for their turn. Guarded by its owner. */
final class ExchangeQueue {
    private final Deque<Exchange> waiting = new ArrayDeque<>();

    void add(Exchange exchange) {
        waiting.addLast(exchange);
    }

    /** For what must be asked before anything else. */
    void addFirst(Exchange exchange) {
        waiting.addFirst(exchange);
    }

    /** Asks once more before all others, but for a stop that waits. */
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

    /** Puts a way of stopping before everything, and throws away what was to move the robot. */
    void stop(Question how) {
        discard(Question.Purpose.MOTION, "stopped");
        if (!holds(how.purpose())) {
            addFirst(new Exchange(how));
        }
    }

    /** The same, but behind what waits first: a robot that always sets its own speeds is asked other things, too. */
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

    /** Ends the waiting of all questions for one purpose. */
    void discard(Question.Purpose purpose, String why) {
        for (Iterator<Exchange> all = waiting.iterator(); all.hasNext(); ) {
            Exchange exchange = all.next();
            if (exchange.purpose() == purpose) {
                all.remove();
                exchange.failed(why);
            }
        }
    }

    /** Ends the waiting of all. */
    void discardAll(String why) {
        waiting.forEach(exchange -> exchange.failed(why));
        waiting.clear();
    }
}
