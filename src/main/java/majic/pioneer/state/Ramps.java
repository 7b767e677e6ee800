package majic.pioneer.state;

import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;

/**
 * Highest speeds, accelerations and decelerations as they are sent to the robot (ARCOS sheet 6.1: SETV, SETA, SETRV,
 * SETRA). Immutable.
 *
 * @param topSpeedMmPerSec of any motion
 * @param topTurnDegPerSec of any turn
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
    /** Enough for a room, even if the model is faster. */
    private static final int CAREFUL_MM_PER_SEC = 1000;

    private static final int CAREFUL_DEG_PER_SEC = 100;

    /** With less a robot hardly starts or stops, mm/s² and deg/s². */
    public static final int GENTLEST = 20;

    /**
     * The ramps that are sent unless a user sets others: gentle, yet sharp enough to stop within the range of the
     * sonars. From the usual 300 mm/s the robot stops within 90 mm.
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

    /** The same, reduced to the limits of a robot. */
    public Ramps within(Limits limits) {
        return new Ramps(
                Math.min(topSpeedMmPerSec, limits.speedMmPerSec()),
                Math.min(topTurnDegPerSec, limits.turnDegPerSec()),
                Math.min(acceleration, limits.accelerationMmPerSec2()),
                Math.min(deceleration, limits.accelerationMmPerSec2()),
                Math.min(turnAcceleration, limits.turnAccelerationDegPerSec2()),
                Math.min(turnDeceleration, limits.turnAccelerationDegPerSec2()));
    }

    /** The packets that set them in the robot. */
    public Packet[] packets() {
        return new Packet[] {
            ArcosCommand.SETV.packet(topSpeedMmPerSec),
            ArcosCommand.SETA.packet(acceleration),
            ArcosCommand.SETA.packet(-deceleration),
            ArcosCommand.SETRV.packet(topTurnDegPerSec),
            ArcosCommand.SETRA.packet(turnAcceleration),
            ArcosCommand.SETRA.packet(-turnDeceleration)
        };
    }
}
