package majic.driver;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * The command that calibrates the speeds of a robot by a measurement of the user: {@code calibrate forward} moves the
 * robot and asks for the distance, {@code calibrate forward 940mm} stores the speed that follows from it. Thread-safe.
 */
public final class CalibrateCommand {
    private static final String NAME = "calibrate";

    /** The time for marking the floor before the robot moves, seconds. */
    private static final int MARKING_S = 5;

    private static final Pattern MEASURED = Pattern.compile("(-?\\d+(?:\\.\\d+)?)(?: (\\S+))?");

    private final CalibratedRobot robot;
    private final Map<String, Trial> trials = new ConcurrentHashMap<>();

    /** A robot whose speeds can be calibrated. */
    public interface CalibratedRobot {
        /**
         * The motions that can be measured.
         *
         * @return their names, such as {@code forward}
         */
        List<String> directions();

        /**
         * Performs a motion to be measured; calls {@link #letMark} before it.
         *
         * @param direction one of {@link #directions()}
         * @param motion for sending and waiting
         * @return the motion, to be measured by the user
         */
        Trial go(String direction, Motion motion);
    }

    /**
     * A motion to be measured. Several measurements may be entered for it; the last one counts.
     *
     * @param believed the distance or angle by the calibration in force, positive, mm or degrees
     * @param unit of that
     * @param credible the measurements that are accepted, in that unit
     * @param calibration stores the calibration for a measurement; returns the message with the old and the new value
     */
    public record Trial(double believed, Unit unit, Range credible, DoubleFunction<String> calibration) {}

    private CalibrateCommand(CalibratedRobot robot) {
        this.robot = robot;
    }

    /**
     * The command for a robot.
     *
     * @param robot moves, and stores its calibration
     * @return a command that moves the robot
     */
    public static DriverCommand of(CalibratedRobot robot) {
        Parameter measured = Parameter.text("measured", "the measured distance or angle");
        Parameter direction =
                Parameter.choice("direction", robot.directions(), "which way").with(measured);
        return new DriverCommand(
                NAME,
                List.of(direction),
                true,
                String.join(", ", robot.directions())
                        + ": moves and shows what to measure; then repeat it with the measured value",
                new CalibrateCommand(robot)::run);
    }

    /**
     * Announces a motion, and waits while the user marks the floor. For a {@link CalibratedRobot}, before it moves.
     *
     * @param motion the motion that is to begin
     * @param mark the mark to be made: {@code where it stands}
     * @param action the motion that follows: {@code drives ahead for 10 s}
     * @throws MotionStopped if the robot is stopped meanwhile
     */
    public static void letMark(Motion motion, String mark, String action) {
        motion.notice("mark " + mark + "; in " + MARKING_S + " s it " + action);
        motion.pause(MARKING_S);
    }

    private String run(List<Value> arguments, Motion motion) {
        String direction = arguments.get(0).toString();
        return arguments.size() == 1
                ? go(direction, motion)
                : learn(direction, arguments.get(1).toString());
    }

    /** Discards the motion before at once, because the user cannot measure it any more. */
    private String go(String direction, Motion motion) {
        trials.remove(direction);
        Trial trial = robot.go(direction, motion);
        trials.put(direction, trial);
        String turns = trial.unit() == Unit.DEG ? " (a whole turn counts 360)" : "";
        return String.format(
                Locale.ROOT,
                "it takes this for %s; measure it%s and type what you saw, as in: %s %s %.0f%s",
                Value.about(trial.believed(), trial.unit()),
                turns,
                NAME,
                direction,
                trial.believed(),
                trial.unit().symbol());
    }

    private String learn(String direction, String measured) {
        Trial trial = trials.get(direction);
        String typed = NAME + " " + direction;
        if (trial == null) {
            throw new BotException(
                    typed + " " + measured + ": nothing to measure yet; \"" + typed + "\" alone moves it first");
        }
        return trial.calibration().apply(credible(trial, typed, measured));
    }

    private static double credible(Trial trial, String typed, String measured) {
        Matcher number = MEASURED.matcher(measured);
        String unit = trial.unit().symbol();
        boolean fits =
                number.matches() && (number.group(2) == null || number.group(2).equals(unit));
        if (!fits || Double.parseDouble(number.group(1)) <= 0) {
            throw new BotException(typed + " " + measured + ": type how far it went as a number above 0 in " + unit
                    + ", without a sign");
        }
        double amount = Double.parseDouble(number.group(1));
        if (!trial.credible().contains(amount)) {
            throw new BotException(String.format(
                    Locale.ROOT,
                    "%s %s: it cannot have gone so far or so little in that time; between %.0f and %.0f %s would do",
                    typed,
                    measured,
                    trial.credible().min(),
                    trial.credible().max(),
                    unit));
        }
        return amount;
    }
}
