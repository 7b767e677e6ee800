package majic.pioneer.state;

import majic.pioneer.arcos.ArcosCommand;

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
public record Ramps(
        int topSpeedMmPerSec,
        int topTurnDegPerSec,
        int acceleration,
        int deceleration,
        int turnAcceleration,
        int turnDeceleration) {
    /** However fast a model is, a room is small. */
    private static final int CAREFUL_MM_PER_SEC = 1000;

    private static final int CAREFUL_DEG_PER_SEC = 100;

    /** Slower than so a robot hardly starts or stops at all, mm/s² and deg/s². */
    public static final int GENTLEST = 20;

    /**
     * What a robot is told unless somebody wants it otherwise: gently, yet able to stop within sight of its sonars. From
     * the usual 300 mm/s it stands after 90 mm.
     */
    public static Ramps careful(Limits limits) {
        return new Ramps(
                        Math.min(CAREFUL_MM_PER_SEC, limits.setSpeedMmPerSec()),
                        Math.min(CAREFUL_DEG_PER_SEC, limits.setTurnDegPerSec()),
                        300,
                        500,
                        100,
                        100)
                .within(limits);
    }

    public Ramps withTopSpeed(int mmPerSec) {
        return new Ramps(mmPerSec, topTurnDegPerSec, acceleration, deceleration, turnAcceleration, turnDeceleration);
    }

    public Ramps withTopTurn(int degPerSec) {
        return new Ramps(topSpeedMmPerSec, degPerSec, acceleration, deceleration, turnAcceleration, turnDeceleration);
    }

    public Ramps withAcceleration(int mmPerSec2) {
        return new Ramps(
                topSpeedMmPerSec, topTurnDegPerSec, mmPerSec2, deceleration, turnAcceleration, turnDeceleration);
    }

    public Ramps withDeceleration(int mmPerSec2) {
        return new Ramps(
                topSpeedMmPerSec, topTurnDegPerSec, acceleration, mmPerSec2, turnAcceleration, turnDeceleration);
    }

    public Ramps withTurnAcceleration(int degPerSec2) {
        return new Ramps(topSpeedMmPerSec, topTurnDegPerSec, acceleration, deceleration, degPerSec2, turnDeceleration);
    }

    public Ramps withTurnDeceleration(int degPerSec2) {
        return new Ramps(topSpeedMmPerSec, topTurnDegPerSec, acceleration, deceleration, turnAcceleration, degPerSec2);
    }

    /** The same, but no faster than a robot can. */
    public Ramps within(Limits limits) {
        return new Ramps(
                Math.min(topSpeedMmPerSec, limits.speedMmPerSec()),
                Math.min(topTurnDegPerSec, limits.turnDegPerSec()),
                Math.min(acceleration, limits.accelerationMmPerSec2()),
                Math.min(deceleration, limits.accelerationMmPerSec2()),
                Math.min(turnAcceleration, limits.turnAccelerationDegPerSec2()),
                Math.min(turnDeceleration, limits.turnAccelerationDegPerSec2()));
    }

    /** What tells the robot, a packet each. */
    public byte[][] packets() {
        return new byte[][] {
            ArcosCommand.SETV.packet(topSpeedMmPerSec),
            ArcosCommand.SETA.packet(acceleration),
            ArcosCommand.SETA.packet(-deceleration),
            ArcosCommand.SETRV.packet(topTurnDegPerSec),
            ArcosCommand.SETRA.packet(turnAcceleration),
            ArcosCommand.SETRA.packet(-turnDeceleration)
        };
    }
}
