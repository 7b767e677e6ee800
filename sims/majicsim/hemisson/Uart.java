package majicsim.hemisson;

import java.util.ArrayDeque;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * The robot's serial port and the time its characters take. A lenient one lets characters wait while the robot is busy, as a serial
 * server would; with overrun, a third waiting one deafens the robot (sheet 4.4). With pacing a character takes 88 µs, both ways, and
 * everything happens at its own time within a step of the lab; without it all happens at once.
 */
final class Uart {
    static final double CHARACTER_SECONDS = 88e-6;
    private static final int RECEIVER_HOLDS = 2;

    private final boolean overrun;
    private final boolean timed;
    private final ArrayDeque<Arrival> waiting = new ArrayDeque<>();
    private final Outbox outbox = new Outbox();
    private double now;
    private double lastArrival;
    private double commandTime;
    private double busyUntil;
    private boolean lookingRarely;
    private boolean deaf;

    /** Overrun without pacing would deafen a client that sends its next command right after a reply that came too early. */
    Uart(HemissonOptions options) {
        overrun = options.hasOverrun();
        timed = options.isPaced() || overrun;
    }

    void arrive(Line from, byte[] bytes) {
        for (byte b : bytes) {
            lastArrival = timed ? Math.max(now, lastArrival) + CHARACTER_SECONDS : now;
            if (!deaf) {
                waiting.add(new Arrival(from, (char) (b & 0xFF), lastArrival));
            }
        }
    }

    /** The firmware looks at its receiver only once a step; nothing but two characters can wait for it, whoever sends them. */
    void lookRarely(boolean rarely) {
        lookingRarely = rarely;
    }

    /** The next character that the firmware gets round to by now; null if there is none. */
    @Nullable
    Arrival next(boolean inStep) {
        if (lookingRarely && !inStep) {
            return null;
        }
        if (receiverOverflows()) {
            deafen();
        }
        Arrival first = waiting.peek();
        if (first == null || Math.max(first.seconds(), busyUntil) > now) {
            return null;
        }
        commandTime = Math.max(first.seconds(), busyUntil);
        return waiting.remove();
    }

    /** Answers the command whose last character was taken last. */
    void reply(Line to, Reply reply) {
        double start = commandTime + reply.measuringSeconds() + (timed ? reply.thinkingSeconds() : 0);
        double scanning = timed ? reply.scanningSeconds() : 0;
        double time = start;
        for (int i = 0; i < reply.text().length(); i++) {
            time += (timed ? CHARACTER_SECONDS : 0) + (i == 1 ? scanning : 0);
            outbox.add(to, reply.text().charAt(i), time);
        }
        busyUntil = time;
        outbox.sendUntil(now);
    }

    /** Says something to all lines, by itself. */
    void say(Iterable<Line> lines, String text) {
        double before = busyUntil;
        for (Line line : lines) {
            busyUntil = before;
            commandTime = before;
            reply(line, Reply.of(text));
        }
    }

    /** The firmware does something else for a while; what is said then, follows it. */
    void busyFor(double seconds) {
        busyUntil = Math.max(commandTime, busyUntil) + seconds;
        commandTime = busyUntil;
    }

    void step(double seconds) {
        now += seconds;
        outbox.sendUntil(now);
    }

    double now() {
        return now;
    }

    void deafen() {
        deaf = true;
        waiting.clear();
    }

    boolean isDeaf() {
        return deaf;
    }

    /** Switched off and on. */
    void powerCycle() {
        deaf = false;
        waiting.clear();
        outbox.clear();
        busyUntil = now;
        commandTime = now;
    }

    private boolean receiverOverflows() {
        if (!overrun && !lookingRarely) {
            return false;
        }
        double until = lookingRarely ? now : Math.min(now, busyUntil);
        return waiting.stream().filter(arrival -> arrival.seconds() <= until).count() > RECEIVER_HOLDS;
    }

    record Arrival(Line from, char character, double seconds) {}
}
