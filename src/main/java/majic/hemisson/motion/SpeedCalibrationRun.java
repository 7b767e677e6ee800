package majic.hemisson.motion;

import java.util.List;
import java.util.Locale;
import majic.bot.Range;
import majic.bot.Unit;
import majic.driver.CalibrateCommand;
import majic.driver.CalibrateCommand.Trial;
import majic.driver.Motion;
import majic.hemisson.line.MotorValues;

/** Runs the calibration: the robot drives or spins for a known time, and the user measures how far it came. */
public final class SpeedCalibrationRun implements CalibrateCommand.CalibratedRobot {
    private static final String FORWARD = "forward";
    private static final String SPIN = "spin";

    /** Long enough that errors of marking and timing do not matter, seconds. */
    private static final int RUN_S = 10;

    /** The credible range of its speed, as a multiple of the speed in the manual. */
    private static final Range SENSIBLE = new Range(0.2, 2.7);

    private final SpeedCalibration calibration;
    private final MotionRunner motions;
    private final Pace pace;

    /** The usual speeds of the robot. */
    public interface Pace {
        /** Straight, mm/s. */
        double mmPerSec();

        /** On the spot, deg/s. */
        double degPerSec();
    }

    public SpeedCalibrationRun(SpeedCalibration calibration, MotionRunner motions, Pace pace) {
        this.calibration = calibration;
        this.motions = motions;
        this.pace = pace;
    }

    @Override
    public List<String> directions() {
        return List.of(FORWARD, SPIN);
    }

    @Override
    public Trial go(String direction, Motion motion) {
        SpeedTable table = calibration.table();
        return direction.equals(FORWARD) ? drive(table, motion) : spin(table, motion);
    }

    private Trial drive(SpeedTable table, Motion motion) {
        double mmPerSec = table.mmPerSec(Math.max(SpeedTable.SLOWEST, table.nearest(pace.mmPerSec())));
        TimedMotion plan = TimedMotion.straight(mmPerSec * RUN_S, mmPerSec, table);
        CalibrateCommand.letMark(
                motion,
                "where it stands",
                "drives ahead for " + RUN_S + " s, about " + Math.round(mmPerSec * RUN_S) + " mm: keep the way free");
        double covered = go(plan, motion);
        double asInManual = covered * SpeedTable.USUAL.mmPerSec(MotorValues.MAX) / table.mmPerSec(MotorValues.MAX);
        Range credible = new Range(SENSIBLE.min() * asInManual, SENSIBLE.max() * asInManual);
        return new Trial(covered, Unit.MM, credible, measured -> learnSpeed(table, table.scaled(measured / covered)));
    }

    private Trial spin(SpeedTable table, Motion motion) {
        double rate = pace.degPerSec();
        TimedMotion plan = TimedMotion.spin(rate * RUN_S, rate, table);
        CalibrateCommand.letMark(
                motion, "which way it looks", "spins to the left for about " + RUN_S + " s: count the turns");
        double covered = go(plan, motion);
        double rolled = covered * table.wheelDistanceMm();
        Range credible = new Range(
                rolled / SpeedCalibration.WHEEL_DISTANCE_MM.max(), rolled / SpeedCalibration.WHEEL_DISTANCE_MM.min());
        return new Trial(covered, Unit.DEG, credible, measured -> learnWheelDistance(table, rolled / measured));
    }

    private double go(TimedMotion plan, Motion motion) {
        return motions.run(plan, motion).number();
    }

    private String learnSpeed(SpeedTable table, SpeedTable better) {
        calibration.learn(better);
        return String.format(
                Locale.ROOT,
                "drove %.1f mm/s at motor value 3 before, drives %.1f mm/s now; kept for this robot",
                table.mmPerSec(3),
                better.mmPerSec(3));
    }

    private String learnWheelDistance(SpeedTable table, double mm) {
        calibration.learn(table.withWheelDistance(mm));
        return String.format(
                Locale.ROOT,
                "wheels were %.1f mm apart before, are %.1f mm now; kept for this robot",
                table.wheelDistanceMm(),
                mm);
    }
}
