package majic.aibo.parameters;

import majic.aibo.body.Calibration;
import majic.aibo.body.Gait;
import majic.aibo.session.CalibrationRun;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;

/** The four factors as parameters, for a dog that was calibrated with another computer. */
public final class CalibrationParameters {
    private final Calibration calibration;
    private final CalibrationRun.Learner learner;

    public CalibrationParameters(Calibration calibration, CalibrationRun.Learner learner) {
        this.calibration = calibration;
        this.learner = learner;
    }

    /** Returns the name of the parameter for a gait. */
    public static String factor(Gait gait) {
        return gait.key() + "Factor";
    }

    public void describe(ParameterTable table) {
        for (Gait gait : Gait.values()) {
            Range range = Calibration.range(gait);
            String unit = gait.isWalk() ? "mm" : "degree";
            table.add(
                            Parameter.number(
                                            factor(gait),
                                            Unit.NONE,
                                            "ms for one " + unit + " " + gait.key() + "; calibrate measures it")
                                    .within(range.min(), range.max()),
                            () -> Value.of(calibration.msPerUnit(gait), Unit.NONE))
                    .kept()
                    .writes(values -> learner.learn(gait, values.get(0).number()));
        }
    }
}
