package majicsim.hemisson;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import majicsim.net.Line;

/**
 * The robot's serial port and the time its characters take. A lenient one lets characters wait while the robot answers, as a serial
 * server would; with overrun, a third waiting one deafens the robot (sheet 4.4). Paced replies leave 88 µs a character.
 */
final class Uart {
    private static final double CHARACTER_SECONDS = 88e-6;
    private static final int RECEIVER_HOLDS = 2;

    private final HemissonOptions options;
    private final ArrayDeque<Arrival> waiting = new ArrayDeque<>();
    private final ArrayDeque<Reply> leaving = new ArrayDeque<>();
    private double now;
    private double busyUntil;
    private boolean deaf;

    Uart(HemissonOptions options) {
        this.options = options;
    }

    void arrive(Line from, byte[] bytes) {
        if (deaf) {
            return;
        }
        for (byte b : bytes) {
            waiting.add(new Arrival(from, (char) (b & 0xFF)));
        }
    }

    /** The next character the firmware gets round to, if there is one. */
    boolean hasNext() {
        if (!deaf && isBusy() && options.overrun() && waiting.size() > RECEIVER_HOLDS) {
            deafen();
        }
        return !deaf && !isBusy() && !waiting.isEmpty();
    }

    Arrival next() {
        return waiting.remove();
    }

    void reply(Line to, String text) {
        double start = Math.max(now, busyUntil);
        double end = start + text.length() * CHARACTER_SECONDS;
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        if (takesTime()) {
            busyUntil = end;
            leaving.add(new Reply(to, bytes, end));
        } else {
            to.send(bytes);
        }
    }

    void step(double seconds) {
        now += seconds;
        while (!leaving.isEmpty() && leaving.peek().end() <= now) {
            Reply reply = leaving.remove();
            reply.to().send(reply.bytes());
        }
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
        leaving.clear();
        busyUntil = now;
    }

    /** Overrun without pacing would deafen a client that sends its next command right after a reply that came too early. */
    private boolean takesTime() {
        return options.overrun() || options.paced();
    }

    private boolean isBusy() {
        return now < busyUntil - 1e-12;
    }

    record Arrival(Line from, char character) {}

    private record Reply(Line to, byte[] bytes, double end) {}
}
