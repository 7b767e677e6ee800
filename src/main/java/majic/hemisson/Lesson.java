package majic.hemisson;

import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.bot.CalibrateCommand;
import majic.bot.CalibrateCommand.Trial;
import majic.bot.Motion;
import majic.bot.Range;
import majic.bot.Unit;

/** How the robot is taught its pace: it drives or spins for a known time, and somebody measures how far it came. */
final class Lesson implements CalibrateCommand.Pupil {
    private static final String FORWARD = "forward";
    private static final String SPIN = "spin";

    /** Long enough for the errors of marking and timing not to matter. */
    private static final int LESSON_S = 10;

    /** For putting a mark on the floor. */
    private static final int MARKING_S = 5;

    /** What is to be believed of a robot, as a multiple of what the manual says. */
    private static final Range SENSIBLE = new Range(0.2, 3);

    private final MajicHemisson bot;

    Lesson(MajicHemisson bot) {
        this.bot = bot;
    }

    @Override
    public List<String> directions() {
        return List.of(FORWARD, SPIN);
    }

    @Override
    public Trial go(String direction, Motion motion) {
        SpeedTable table = bot.speeds();
        return direction.equals(FORWARD) ? drive(table, motion) : spin(table, motion);
    }

    private Trial drive(SpeedTable table, Motion motion) {
        double mmPerSec = table.mmPerSec(Math.max(SpeedTable.SLOWEST, table.nearest(bot.cruise())));
        Leg leg = Leg.straight(mmPerSec * LESSON_S, mmPerSec, table);
        bot.say("mark where it stands; in " + MARKING_S + " s it drives ahead for " + LESSON_S + " s, about "
                + Math.round(mmPerSec * LESSON_S) + " mm: keep the way free");
        double covered = go(leg, motion);
        return new Trial(covered, Unit.MM, measured -> learnSpeed(table, covered, measured));
    }

    private Trial spin(SpeedTable table, Motion motion) {
        double rate = bot.cruiseTurn();
        Leg leg = Leg.spin(rate * LESSON_S, rate, table);
        bot.say("mark which way it looks; in " + MARKING_S + " s it spins to the left for about " + LESSON_S
                + " s: count the turns");
        double covered = go(leg, motion);
        return new Trial(covered, Unit.DEG, measured -> learnWheelDistance(table, covered, measured));
    }

    private double go(Leg leg, Motion motion) {
        motion.pause(MARKING_S);
        return new OpenLoop(bot, motion).run(leg).number();
    }

    private String learnSpeed(SpeedTable table, double covered, double measured) {
        SpeedTable better = table.scaled(measured / covered);
        double manual = SpeedTable.USUAL.fastestMmPerSec();
        check(FORWARD, measured, "mm", better.mmPerSec(Wheels.MAX) / manual, covered);
        bot.learn(better);
        return String.format(
                Locale.ROOT,
                "drove %.1f mm/s at motor value 3 before, drives %.1f mm/s now; kept for this robot",
                table.mmPerSec(3),
                better.mmPerSec(3));
    }

    private String learnWheelDistance(SpeedTable table, double covered, double measured) {
        double mm = table.wheelDistanceMm() * covered / measured;
        check(SPIN, measured, "deg", mm / SpeedTable.USUAL_WHEEL_DISTANCE_MM, covered);
        double kept = Calibration.WHEEL_DISTANCE_MM.clamp(mm);
        bot.learn(table.withWheelDistance(kept));
        return String.format(
                Locale.ROOT,
                "wheels were %.1f mm apart before, are %.1f mm now; kept for this robot",
                table.wheelDistanceMm(),
                kept);
    }

    private static void check(String direction, double measured, String unit, double ofManual, double covered) {
        if (!SENSIBLE.contains(ofManual)) {
            throw new BotException(String.format(
                    Locale.ROOT,
                    "calibrate %s %.0f%s: no Hemisson goes so far or so little in that time; it took itself to have gone "
                            + "%.0f %s",
                    direction,
                    measured,
                    unit,
                    covered,
                    unit));
        }
    }
}
