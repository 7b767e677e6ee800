package majic.driver;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.Motion;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * The command by which a person with a ruler teaches a robot its own pace: {@code calibrate forward} moves it and says
 * what to measure, {@code calibrate forward 940mm} tells it what was measured. Safe from any thread.
 */
public final class CalibrateCommand {
    private static final String NAME = "calibrate";

    /** For putting a mark on the floor, seconds. */
    private static final int MARKING_S = 5;

    private static final Pattern MEASURED = Pattern.compile("(-?\\d+(?:\\.\\d+)?)(?: (\\S+))?");

    private final Pupil pupil;
    private final Map<String, Trial> trials = new ConcurrentHashMap<>();

    /** A robot that can be taught. */
    public interface Pupil {
        /**
         * What can be measured.
         *
         * @return words for it, such as {@code forward}
         */
        List<String> directions();

        /**
         * Moves the robot so that somebody can measure it; before that calls {@link #letMark}.
         *
         * @param direction one of {@link #directions()}
         * @param motion for sending and waiting
         * @return what it did
         */
        Trial go(String direction, Motion motion);
    }

    /**
     * What a robot has done to be measured. Can be learned from more than once, so that a slip of the pen can be mended.
     *
     * @param believed how far it takes itself to have gone, positive, mm or degrees
     * @param unit of that
     * @param credible what can have been measured, in that unit; anything else is refused
     * @param lesson takes what was measured; keeps what follows and tells old and new
     */
    public record Trial(double believed, Unit unit, Range credible, DoubleFunction<String> lesson) {}

    private CalibrateCommand(Pupil pupil) {
        this.pupil = pupil;
    }

    /**
     * The command for a robot.
     *
     * @param pupil what moves and learns
     * @return a command that moves the robot
     */
    public static BotCommand of(Pupil pupil) {
        Parameter measured = Parameter.text("measured", "what the ruler says");
        Parameter direction =
                Parameter.choice("direction", pupil.directions(), "which way").with(measured);
        return new BotCommand(
                NAME,
                List.of(direction),
                true,
                String.join(", ", pupil.directions())
                        + ": moves and says what to measure; then the same with what you measured behind it",
                new CalibrateCommand(pupil)::run);
    }

    /**
     * Says what to mark and what will come, and leaves the time for it. For a {@link Pupil}, before it moves.
     *
     * @param motion the motion that is to begin
     * @param mark what to mark: {@code where it stands}
     * @param deed what it does then: {@code drives ahead for 10 s}
     * @throws MotionStopped if somebody stops it meanwhile
     */
    public static void letMark(Motion motion, String mark, String deed) {
        motion.say("mark " + mark + "; in " + MARKING_S + " s it " + deed);
        motion.pause(MARKING_S);
    }

    private String run(List<Value> arguments, Motion motion) {
        String direction = arguments.get(0).toString();
        return arguments.size() == 1
                ? go(direction, motion)
                : learn(direction, arguments.get(1).toString());
    }

    /** What was done before is forgotten at once: nobody measures that any more. */
    private String go(String direction, Motion motion) {
        trials.remove(direction);
        Trial trial = pupil.go(direction, motion);
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
        return trial.lesson().apply(credible(trial, typed, measured));
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
