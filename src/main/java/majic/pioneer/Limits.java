package majic.pioneer;

import majic.pioneer.arcos.Config;
import org.jspecify.annotations.Nullable;

/**
 * The fastest a robot can be let go: what its model is built for, and what its controller says of itself. A limit the
 * controller leaves at zero is the model's (ARCOS sheet 12). Immutable.
 *
 * @param speedMmPerSec that nothing can raise
 * @param turnDegPerSec that nothing can raise
 * @param setSpeedMmPerSec what the robot's owner has set in it; no more than the first
 * @param setTurnDegPerSec what the robot's owner has set in it; no more than the second
 */
record Limits(int speedMmPerSec, int turnDegPerSec, int setSpeedMmPerSec, int setTurnDegPerSec) {

    /** Those of a model, and of one robot once its CONFIG packet has come. */
    static Limits of(Model model, @Nullable Config config) {
        int modelSpeed = (int) model.topSpeedMmPerSec();
        int modelTurn = (int) model.topTurnDegPerSec();
        if (config == null) {
            return new Limits(modelSpeed, modelTurn, modelSpeed, modelTurn);
        }
        int speed = lower(modelSpeed, config.speedTopMmPerSec());
        int turn = lower(modelTurn, config.turnTopDegPerSec());
        return new Limits(speed, turn, lower(speed, config.speedMaxMmPerSec()), lower(turn, config.turnMaxDegPerSec()));
    }

    private static int lower(int known, int told) {
        return told > 0 ? Math.min(known, told) : known;
    }
}
