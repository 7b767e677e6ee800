package majicsim.hemisson.board;

/** What the keys of a TV remote do in remote control mode (sheet 8). */
public final class TvRemote {
    private static final int[][] SPEEDS = {
        {5, 10}, {10, 10}, {10, 5}, {-10, 10}, {0, 0}, {10, -10}, {-5, -10}, {-10, -10}, {-10, -5}
    };

    private TvRemote() {}

    /** Speeds left and right of keys 1 to 9; other keys drive nothing. */
    public static void drive(int key, Motors motors) {
        if (key >= 1 && key <= SPEEDS.length) {
            motors.set(SPEEDS[key - 1][0], SPEEDS[key - 1][1]);
        }
    }
}
