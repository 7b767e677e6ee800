package majic.pioneer.state;

import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import org.jspecify.annotations.Nullable;

/**
 * The fastest a robot can be let go: what its model is built for, and what its controller says of itself. A limit the
 * controller leaves at zero is the model's (ARCOS sheet 12). Immutable.
 *
 * @param speedMmPerSec that nothing can raise
 * @param turnDegPerSec that nothing can raise
 * @param setSpeedMmPerSec what the robot's owner has set in it; no more than the first
 * @param setTurnDegPerSec what the robot's owner has set in it; no more than the second
 * @param accelerationMmPerSec2 speeding up and braking
 * @param turnAccelerationDegPerSec2 speeding up and braking
 */
public record Limits(
        int speedMmPerSec,
        int turnDegPerSec,
        int setSpeedMmPerSec,
        int setTurnDegPerSec,
        int accelerationMmPerSec2,
        int turnAccelerationDegPerSec2) {
    /** What tyres hold and loads stand, whatever a controller takes; turning, it is the same at the wheels. */
    private static final int SHARPEST_MM_PER_SEC2 = 2000;

    private static final int SHARPEST_DEG_PER_SEC2 = 500;

    /** Those of a model, and of one robot once its CONFIG packet has come. */
    public static Limits of(Model model, @Nullable Config config) {
        int modelSpeed = (int) model.topSpeedMmPerSec();
        int modelTurn = (int) model.topTurnDegPerSec();
        if (config == null) {
            return new Limits(
                    modelSpeed, modelTurn, modelSpeed, modelTurn, SHARPEST_MM_PER_SEC2, SHARPEST_DEG_PER_SEC2);
        }
        int speed = lower(modelSpeed, config.speedTopMmPerSec());
        int turn = lower(modelTurn, config.turnTopDegPerSec());
        return new Limits(
                speed,
                turn,
                lower(speed, config.speedMaxMmPerSec()),
                lower(turn, config.turnMaxDegPerSec()),
                gentle(SHARPEST_MM_PER_SEC2, config.number(ConfigField.TRANSACCTOP)),
                gentle(SHARPEST_DEG_PER_SEC2, config.number(ConfigField.ROTACCTOP)));
    }

    private static int gentle(int known, long told) {
        return Math.max(Ramps.GENTLEST, lower(known, (int) told));
    }

    private static int lower(int known, int told) {
        return told > 0 ? Math.min(known, told) : known;
    }
}
