package majicsim.hemisson;

/**
 * The firmware's two sensor tables, refreshed every 41 ms (sheet 4.6 and 6). Proximity is ambient minus lit, modulo 256, never above the
 * ambient value; ground left subtracts from the ambient value of ground right, a slip of the real firmware.
 */
final class InfraRed {
    private static final double ROUND_SECONDS = 0.041;
    private static final int GROUND_RIGHT = 6;
    private static final int GROUND_LEFT = 7;
    private static final double HAIR = 1e-9;

    private final Eyes eyes;
    private final int[] ambient = new int[Eyes.COUNT];
    private final int[] proximity = new int[Eyes.COUNT];
    private final int[] response = new int[Eyes.COUNT];
    private double sinceSeconds;
    private boolean fresh;

    InfraRed(Eyes eyes) {
        this.eyes = eyes;
        refresh();
    }

    /** True when a round has just ended. */
    boolean step(double seconds) {
        sinceSeconds += seconds;
        if (sinceSeconds < ROUND_SECONDS - HAIR) {
            return false;
        }
        sinceSeconds -= ROUND_SECONDS;
        refresh();
        return true;
    }

    int proximity(int sensor) {
        return proximity[sensor];
    }

    int ambient(int sensor) {
        return ambient[sensor];
    }

    /** Whether the tables were refreshed since this was last asked. */
    boolean takeFresh() {
        boolean was = fresh;
        fresh = false;
        return was;
    }

    /** A long command's characters land in the tables, which lie behind the buffer's head in the same memory (sheet 4.2). */
    void overwrite(int cell, int value) {
        if (cell >= 0 && cell < Eyes.COUNT) {
            proximity[cell] = value;
        } else if (cell >= Eyes.COUNT && cell < 2 * Eyes.COUNT) {
            ambient[cell - Eyes.COUNT] = value;
        }
    }

    private void refresh() {
        eyes.look(ambient, response);
        for (int i = 0; i < Eyes.COUNT; i++) {
            int lit = Math.max(0, ambient[i] - response[i]);
            int minuend = i == GROUND_LEFT ? ambient[GROUND_RIGHT] : ambient[i];
            proximity[i] = (minuend - lit) & 0xFF;
        }
        fresh = true;
    }
}
