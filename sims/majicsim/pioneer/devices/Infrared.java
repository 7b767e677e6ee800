package majicsim.pioneer.devices;

import java.util.Objects;

/**
 * The short-range infra-red sensors: 8 in the IO packet, active low, and the two that look down for a ledge (ARCOS
 * sheet 8.1, 11.2).
 */
public final class Infrared {
    private static final int ALL = 0xFF;
    private static final int FAR_LEDGE = 1 << 7;
    private static final int NEAR_LEDGE = 1 << 8;

    private int seen;
    private int ledges;

    /** Sets whether one of the 8 sensors detects an object. */
    public void see(int eye, boolean something) {
        Objects.checkIndex(eye, Byte.SIZE);
        seen = something ? seen | 1 << eye : seen & ~(1 << eye);
    }

    /** Sets whether the floor ends ahead: farther away, close by, or both. */
    public void ledge(boolean far, boolean near) {
        ledges = (far ? FAR_LEDGE : 0) | (near ? NEAR_LEDGE : 0);
    }

    public int activeLow() {
        return ~seen & ALL;
    }

    /** Bits 7 and 8 of FLAGS. */
    public int flags() {
        return ledges;
    }
}
