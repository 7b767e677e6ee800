package majicsim.net;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import majicsim.world.Noise;

/**
 * The faults of a robot's lines. They may be ordered at any time and from any thread, take effect at once, last until
 * {@link #none()}, and hold for both directions unless stated otherwise. Times are lab time.
 */
public final class Faults {
    private static final double NANOS_PER_MS = 1e6;
    private static final long NO_OUTAGE = Long.MIN_VALUE;

    private final Noise noise;
    private final LabTime time;
    private final List<Runnable> watchers = new CopyOnWriteArrayList<>();
    private final List<Runnable> cutters = new CopyOnWriteArrayList<>();
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private volatile double delayMs;
    private volatile double bytesPerSecond = Double.POSITIVE_INFINITY;
    private volatile double garbleProbability;
    private volatile double lossProbability;
    private volatile boolean halving;
    private volatile boolean readingStopped;
    private volatile boolean unreachable;
    private final AtomicLong outageUntilNanos = new AtomicLong(NO_OUTAGE);
    private volatile double jitterFromMs;
    private volatile double jitterToMs;

    /**
     * No faults yet, for lines outside of a lab, whose steps alone let time pass.
     *
     * @param noise draws jitter and garbled bytes; with the exact one there is no jitter, and garbling happens only if
     *     it is certain
     */
    public Faults(Noise noise) {
        this(noise, new LabTime());
    }

    /**
     * No faults yet.
     *
     * @param noise as above
     * @param time of the lab
     */
    public Faults(Noise noise, LabTime time) {
        this.noise = noise;
        this.time = time;
    }

    /**
     * Cuts all present lines; what was not delivered is lost. New lines are accepted. A pseudo-terminal loses bytes and
     * stays open.
     */
    public void cut() {
        cutters.forEach(Runnable::run);
    }

    /**
     * Cuts all present lines and refuses new ones, as a robot does that is switched off. {@link #none()} brings it back
     * at the same ports. A pseudo-terminal stays open and loses all bytes meanwhile. Do not call it, nor
     * {@link #none()}, with the lab's lock held.
     */
    public void unreachable() {
        unreachable = true;
        cut();
        changed();
        listeners.forEach(Runnable::run);
    }

    /**
     * Delivers everything later, in order.
     *
     * @param ms 0 or more, each way
     * @throws IllegalArgumentException if it is below 0; nothing changes
     */
    public void delay(double ms) {
        check(ms >= 0, "a delay must be 0 ms or more, not " + ms);
        delayMs = ms;
    }

    /**
     * Lets each line carry only so many bytes in a second, each way; what comes faster waits on the line, in order and
     * without a limit.
     *
     * @param rate bytes in a second, above 0
     * @throws IllegalArgumentException if it is not above 0; nothing changes
     */
    public void bandwidth(double rate) {
        check(rate > 0, "a bandwidth must be above 0 bytes in a second, not " + rate);
        bytesPerSecond = rate;
    }

    /**
     * Damages bytes.
     *
     * @param probability of each byte to be replaced by a random one, 0 to 1
     * @throws IllegalArgumentException if it is outside that range; nothing changes
     */
    public void garble(double probability) {
        check(probability >= 0 && probability <= 1, "a probability must be 0 to 1, not " + probability);
        garbleProbability = probability;
    }

    /**
     * Loses datagrams. Lines other than those of datagrams lose nothing.
     *
     * @param probability of each datagram, 0 to 1
     * @throws IllegalArgumentException if it is outside that range; nothing changes
     */
    public void lose(double probability) {
        check(probability >= 0 && probability <= 1, "a probability must be 0 to 1, not " + probability);
        lossProbability = probability;
    }

    /** Delivers each message in two pieces, the second one lab step after the first. */
    public void halfPackets() {
        halving = true;
    }

    /** Leaves everything that clients send unread; the robot goes on sending. */
    public void stopReading() {
        readingStopped = true;
        changed();
    }

    /**
     * Holds everything in both directions for a time, then delivers all of it.
     *
     * @param seconds from now
     */
    public void outage(double seconds) {
        outageUntilNanos.set(time.nowNanos() + (long) (seconds * 1e9));
        changed();
    }

    /**
     * Makes an exchange over the network take a varying time; each direction draws half of it. Not a fault:
     * {@link #none()} leaves it. A pseudo-terminal, like the wire it stands for, has none.
     *
     * @param fromMs the shortest an exchange takes, 0 or more
     * @param toMs the longest
     * @throws IllegalArgumentException if it is no range; nothing changes
     */
    public void jitter(double fromMs, double toMs) {
        check(fromMs >= 0 && toMs >= fromMs, "jitter must be a range from 0 ms up, not " + fromMs + " to " + toMs);
        jitterFromMs = fromMs;
        jitterToMs = toMs;
    }

    /** Ends all faults; what they held back is delivered with the next step. */
    public void none() {
        delayMs = 0;
        bytesPerSecond = Double.POSITIVE_INFINITY;
        garbleProbability = 0;
        lossProbability = 0;
        halving = false;
        readingStopped = false;
        outageUntilNanos.set(NO_OUTAGE);
        boolean returns = unreachable;
        unreachable = false;
        changed();
        if (returns) {
            listeners.forEach(Runnable::run);
        }
    }

    /** A port that is notified when reading stops or continues, and when its lines are to be cut. */
    void attach(Runnable watcher, Runnable cutter) {
        watchers.add(watcher);
        cutters.add(cutter);
    }

    /** A port that closes its listener while the robot is unreachable; the action waits until that is so. */
    void attachListener(Runnable await) {
        listeners.add(await);
    }

    /**
     * Reports that the lines have reached this time, and notifies the ports when an outage has ended. Returns whether
     * there is one.
     */
    boolean tick(long nowNanos) {
        time.reach(nowNanos);
        long until = outageUntilNanos.get();
        if (until != NO_OUTAGE && nowNanos >= until && outageUntilNanos.compareAndSet(until, NO_OUTAGE)) {
            changed();
        }
        return isOutage();
    }

    LabTime time() {
        return time;
    }

    boolean isReading() {
        return !readingStopped && !isOutage();
    }

    boolean isReachable() {
        return !unreachable;
    }

    boolean isOutage() {
        return time.nowNanos() < outageUntilNanos.get();
    }

    /** Whether the next datagram is lost; drawn anew each time. */
    boolean drawLoss() {
        double probability = lossProbability;
        return probability > 0 && noise.chance(probability);
    }

    boolean isHalving() {
        return halving;
    }

    /** The ordered delay. */
    long delayNanos() {
        return (long) (delayMs * NANOS_PER_MS);
    }

    /** How long this many bytes take a line; 0 without a limited bandwidth. */
    long transmissionNanos(int bytes) {
        return (long) (bytes / bytesPerSecond * 1e9);
    }

    /** A further delay, drawn anew each time; none without noise. */
    long drawJitterNanos() {
        return jitterToMs > 0 && !noise.isExact()
                ? (long) (noise.uniform(jitterFromMs, jitterToMs) / 2 * NANOS_PER_MS)
                : 0;
    }

    byte[] garbled(byte[] message) {
        double probability = garbleProbability;
        if (probability <= 0) {
            return message;
        }
        byte[] damaged = message.clone();
        for (int i = 0; i < damaged.length; i++) {
            if (noise.chance(probability)) {
                damaged[i] = (byte) (damaged[i] ^ (1 + (int) noise.uniform(0, 255)));
            }
        }
        return damaged;
    }

    /** Waits until reading is allowed again, for at most this time. */
    synchronized void awaitReading(long timeoutMs) throws InterruptedException {
        if (!isReading()) {
            wait(timeoutMs);
        }
    }

    private static void check(boolean isTrue, String message) {
        if (!isTrue) {
            throw new IllegalArgumentException(message);
        }
    }

    private void changed() {
        time.makeAllDue();
        synchronized (this) {
            notifyAll();
        }
        watchers.forEach(Runnable::run);
    }
}
