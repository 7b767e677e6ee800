package majic.gui.drive;

/**
 * The state of a game controller at one moment.
 *
 * @param connected whether it is plugged in
 * @param held whether the button is pressed that must be held to drive
 * @param forward position of the stick, 1 ahead to −1 back
 * @param left position of the stick, 1 left to −1 right
 */
record GamepadState(boolean connected, boolean held, double forward, double left) {
    static final GamepadState UNPLUGGED = new GamepadState(false, false, 0, 0);

    /** Share of the way within which a released stick can rest. */
    private static final double DEAD = 0.15;

    /** Creates a state from raw positions, which have a range around the middle where they count as 0. */
    static GamepadState of(boolean held, double forward, double left) {
        return new GamepadState(true, held, live(forward), live(left));
    }

    private static double live(double position) {
        double size = Math.min(1, Math.abs(position));
        return size <= DEAD ? 0 : Math.signum(position) * (size - DEAD) / (1 - DEAD);
    }

    /** Returns whether robots are to be driven: only while the button is held and the stick is off its middle. */
    boolean drives() {
        return connected && held && (forward != 0 || left != 0);
    }
}
