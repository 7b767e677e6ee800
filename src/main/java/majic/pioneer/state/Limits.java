package majic.pioneer.state;

import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import org.jspecify.annotations.Nullable;

/**
 * Upper bounds of speed and acceleration: those that the model is built for, and those that the controller reports. A
 * reported zero means the model's limit (ARCOS sheet 12). Immutable.
 *
 * @param speedMmPerSec that nothing can raise
 * @param turnDegPerSec that nothing can raise
 * @param setSpeedMmPerSec as set in the robot by its owner; at most the first
 * @param setTurnDegPerSec as set in the robot by its owner; at most the second
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
    /** Safe for tyres and loads, even if a controller accepts more; the turning value is the same at the wheels. */
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

    private static int gentle(int known, long reported) {
        return Math.max(Ramps.GENTLEST, lower(known, (int) reported));
    }

    private static int lower(int known, int reported) {
        return reported > 0 ? Math.min(known, reported) : known;
    }
}
