package majic.pioneer;

/** How sharply the robot is told to speed up and slow down: gently, yet able to stop within sight of its sonars. */
final class Ramps {
    /** mm/s². */
    static final int ACCELERATION = 300;

    /** mm/s²; from the usual 300 mm/s it stands after 90 mm. */
    static final int DECELERATION = 500;

    /** deg/s², both ways. */
    static final int TURN_ACCELERATION = 100;

    private Ramps() {}
}
