package majicsim.hemisson.uart;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * The robot's serial port as its firmware uses it: an interrupt takes the characters that have arrived out of the
 * receiver, and a command is answered inside that interrupt, which lasts until the transmitter has a place for the last
 * character of the answer. The receiver holds two characters; with overrun a third one stops it until the power is
 * switched off and on (sheet 4.4). Without overrun characters wait outside until they are taken, as behind a serial
 * server. With pacing a character takes 88 µs, both ways, and everything happens at its own time within a step of the
 * lab; without it all happens at once.
 */
public final class Uart {
    static final double CHARACTER_SECONDS = 88e-6;

    /** From a character's arrival, or the end of the interrupt before, until the interrupt takes it. */
    private static final double INTERRUPT_SECONDS = 24e-6;

    private static final int RECEIVER_HOLDS = 2;

    private final boolean overrun;
    private final boolean timed;
    private final ArrayDeque<Arrival> waiting = new ArrayDeque<>();
    private final CharacterQueue outbox = new CharacterQueue();
    private final double characterSeconds;
    /** When the transmission of the last character ends, and that of the one before it. */
    private double lastLeft;

    private double beforeLastLeft;
    private double now;
    private double lastArrival;
    private double takenAt;
    private double freeAt;
    private boolean lookingRarely;
    private boolean receiverBlocked;

    /**
     * Overrun without pacing would cut off a client that sends its next command right after a reply that came too
     * early.
     */
    public Uart(HemissonOptions options) {
        overrun = options.hasOverrun();
        timed = options.isPaced() || overrun;
        characterSeconds = timed ? CHARACTER_SECONDS : 0;
    }

    public void arrive(Line from, byte[] bytes) {
        for (byte b : bytes) {
            lastArrival = timed ? Math.max(now, lastArrival) + CHARACTER_SECONDS : now;
            if (!receiverBlocked) {
                waiting.add(new Arrival(from, (char) (b & 0xFF), lastArrival));
            }
        }
    }

    /** The firmware looks at its receiver only once a step; nothing but two characters can wait for it. */
    public void lookRarely(boolean rarely) {
        lookingRarely = rarely;
    }

    /** The next character that the firmware takes by now; null if there is none. */
    public @Nullable Arrival next(boolean inStep) {
        if (lookingRarely && !inStep) {
            return null;
        }
        Arrival first = waiting.peek();
        if (first == null) {
            return null;
        }
        double taken = lookingRarely ? now : Math.max(first.seconds(), freeAt) + (timed ? INTERRUPT_SECONDS : 0);
        overflow(Math.min(taken, now));
        if (taken > now) {
            return null;
        }
        takenAt = taken;
        freeAt = taken;
        return waiting.remove();
    }

    /** Whether the interrupt that took the last character finds one more in the receiver. */
    public boolean hasMore() {
        Arrival next = waiting.peek();
        return isBounded() && next != null && next.seconds() <= takenAt;
    }

    /** Answers the command that ended with the last character. */
    public void reply(Line to, Reply reply) {
        send(List.of(to), reply);
    }

    /** Sends a text to all lines, without a command. */
    public void announce(Collection<Line> lines, String text) {
        send(lines, Reply.of(text));
    }

    /** Keeps the firmware busy for a time; what is sent meanwhile follows afterwards. */
    public void busyFor(double seconds) {
        freeAt += seconds;
    }

    /** Whether no character waits in either direction. */
    public boolean isIdle() {
        return waiting.isEmpty() && outbox.isEmpty();
    }

    public void step(double seconds) {
        now += seconds;
        outbox.sendUntil(now);
    }

    public boolean isReceiverBlocked() {
        return receiverBlocked;
    }

    /** Switches it off and on. */
    public void powerCycle() {
        receiverBlocked = false;
        waiting.clear();
        outbox.clear();
        lastLeft = now;
        beforeLastLeft = now;
        freeAt = now;
    }

    private void send(Collection<Line> lines, Reply reply) {
        double written = freeAt + reply.measuringSeconds() + (timed ? reply.thinkingSeconds() : 0);
        for (int i = 0; i < reply.text().length(); i++) {
            written = Math.max(written, beforeLastLeft) + (timed && i == 1 ? reply.scanningSeconds() : 0);
            double left = transmit(written);
            for (Line line : lines) {
                outbox.add(line, reply.text().charAt(i), left);
            }
        }
        freeAt = written;
        outbox.sendUntil(now);
    }

    /**
     * Writes a character into the transmitter, which holds two: the one being sent and the next. Returns the time at
     * which its transmission ends.
     *
     * @param seconds a time at which the character before the last has been sent
     */
    private double transmit(double seconds) {
        beforeLastLeft = lastLeft;
        lastLeft = Math.max(seconds, lastLeft) + characterSeconds;
        return lastLeft;
    }

    /**
     * A third character that has arrived before the first was taken stops the receiver; the two in it can still be
     * taken.
     */
    private void overflow(double until) {
        Iterator<Arrival> arrivals = waiting.iterator();
        for (int i = 0; i < RECEIVER_HOLDS && arrivals.hasNext(); i++) {
            arrivals.next();
        }
        if (isBounded() && arrivals.hasNext() && arrivals.next().seconds() <= until) {
            receiverBlocked = true;
            while (waiting.size() > RECEIVER_HOLDS) {
                waiting.removeLast();
            }
        }
    }

    private boolean isBounded() {
        return overrun || lookingRarely;
    }

    /** A character from a client, with the time at which it has arrived. */
    public record Arrival(Line from, char character, double seconds) {}
}
