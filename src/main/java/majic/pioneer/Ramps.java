package majic.pioneer;

import majic.pioneer.arcos.Command;

/**
 * How fast the robot may go and how sharply it speeds up and slows down, as it is told (ARCOS sheet 6.1: SETV, SETA,
 * SETRV, SETRA). Immutable.
 *
 * @param topSpeedMmPerSec no motion is faster
 * @param topTurnDegPerSec no turn is faster
 * @param acceleration mm/s²
 * @param deceleration mm/s²
 * @param turnAcceleration deg/s²
 * @param turnDeceleration deg/s²
 */
record Ramps(
        int topSpeedMmPerSec,
        int topTurnDegPerSec,
        int acceleration,
        int deceleration,
        int turnAcceleration,
        int turnDeceleration) {
    /** However fast a model is, a room is small. */
    private static final int CAREFUL_MM_PER_SEC = 1000;

    private static final int CAREFUL_DEG_PER_SEC = 100;

    /**
     * What a robot is told unless somebody wants it otherwise: gently, yet able to stop within sight of its sonars. From
     * the usual 300 mm/s it stands after 90 mm.
     */
    static Ramps careful(Limits limits) {
        return new Ramps(
                Math.min(CAREFUL_MM_PER_SEC, limits.setSpeedMmPerSec()),
                Math.min(CAREFUL_DEG_PER_SEC, limits.setTurnDegPerSec()),
                300,
                500,
                100,
                100);
    }

    /** The same, but no faster than a robot can. */
    Ramps within(Limits limits) {
        return new Ramps(
                Math.min(topSpeedMmPerSec, limits.speedMmPerSec()),
                Math.min(topTurnDegPerSec, limits.turnDegPerSec()),
                acceleration,
                deceleration,
                turnAcceleration,
                turnDeceleration);
    }

    /** What tells the robot, a packet each. */
    byte[][] packets() {
        return new byte[][] {
            Command.SETV.packet(topSpeedMmPerSec),
            Command.SETA.packet(acceleration),
            Command.SETA.packet(-deceleration),
            Command.SETRV.packet(topTurnDegPerSec),
            Command.SETRA.packet(turnAcceleration),
            Command.SETRA.packet(-turnDeceleration)
        };
    }
}
