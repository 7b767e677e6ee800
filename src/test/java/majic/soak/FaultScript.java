package majic.soak;

import java.util.Random;
import majicsim.net.Faults;

/**
 * Draws the faults of one robot's connection from a seed. The first ones of five robots include every kind. Used by one
 * thread.
 */
final class FaultScript {
    private static final int BEGINNING = 2;
    private static final int KINDS = Kind.values().length;

    private final Random random;
    private final int robot;
    private int kinds;

    /** The kinds of faults. */
    enum Kind {
        CUT,
        DELAY,
        GARBLE,
        HALVE,
        STOP_READING,
        OUTAGE,
        UNREACHABLE
    }

    FaultScript(long seed, int robot) {
        this.random = new Random(seed * 131 + robot);
        this.robot = robot;
    }

    /** Returns how long the robot's connection is without fault, seconds. */
    double goodSeconds() {
        return 0.2 + random.nextInt(8000) / 1000.0;
    }

    /** Returns how long a fault lasts, seconds; some outlast every time limit of the drivers. */
    double faultSeconds() {
        return random.nextInt(random.nextInt(5) == 0 ? 12_000 : 1500) / 1000.0;
    }

    /** Orders the next fault, which lasts until {@link Faults#none()}. */
    Kind next(Faults faults) {
        Kind kind = Kind.values()[kinds++ < BEGINNING ? (3 * robot + kinds) % KINDS : random.nextInt(KINDS)];
        switch (kind) {
            case CUT -> faults.cut();
            case DELAY -> faults.delay(20 + random.nextInt(1500));
            case GARBLE -> faults.garble(random.nextInt(300) / 1000.0);
            case HALVE -> faults.halfPackets();
            case STOP_READING -> faults.stopReading();
            case OUTAGE -> faults.outage(random.nextInt(4000) / 1000.0);
            case UNREACHABLE -> faults.unreachable();
        }
        return kind;
    }
}
