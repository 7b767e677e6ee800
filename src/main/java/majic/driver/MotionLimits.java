package majic.driver;

import majic.bot.BotProfile;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * The limits of speed and distance of one robot: those of its profile and the parameters that set others, beside those
 * that say how it behaves towards obstacles and other robots. Its checks throw what the motion itself would throw, so
 * that a script can be checked before any robot moves. Thread-safe.
 */
final class MotionLimits {
    private static final double MAX_MOVE_MM = 5000;
    private static final double MAX_TURN_DEG = 36_000;
    private static final double MAX_DRIVE_SECONDS = 60;

    private final BotProfile profile;
    private volatile double maxMoveMm = MAX_MOVE_MM;
    private volatile double cruiseMmPerSec;
    private volatile double cruiseTurnDegPerSec;
    private volatile boolean guarded;
    private volatile boolean givesWay;

    /** The value that was set; null for the value of the profile. */
    private volatile @Nullable Double cruiseSet;

    private volatile @Nullable Double cruiseTurnSet;
    private volatile @Nullable Double nearSet;

    MotionLimits(BotProfile profile) {
        this.profile = profile;
        setCruise(null);
        setCruiseTurn(null);
    }

    /** Returns the limits for another profile; parameters that were set stay set, as far as the robot allows. */
    MotionLimits fittedTo(BotProfile better) {
        MotionLimits fitted = new MotionLimits(better);
        fitted.maxMoveMm = maxMoveMm;
        fitted.setCruise(cruiseSet);
        fitted.setCruiseTurn(cruiseTurnSet);
        fitted.nearSet = nearSet;
        fitted.guarded = guarded;
        fitted.givesWay = givesWay;
        return fitted;
    }

    BotProfile profile() {
        return profile;
    }

    private void setCruise(@Nullable Double mmPerSec) {
        cruiseSet = mmPerSec;
        cruiseMmPerSec = profile.speed().clamp(or(mmPerSec, profile.cruiseMmPerSec()));
    }

    private void setCruiseTurn(@Nullable Double degPerSec) {
        cruiseTurnSet = degPerSec;
        cruiseTurnDegPerSec = profile.turn().clamp(or(degPerSec, profile.cruiseTurnDegPerSec()));
    }

    void maxMove(double mm) {
        maxMoveMm = mm;
    }

    double cruiseMmPerSec() {
        return cruiseMmPerSec;
    }

    double cruiseTurnDegPerSec() {
        return cruiseTurnDegPerSec;
    }

    boolean isGuarded() {
        return guarded;
    }

    private double nearMm() {
        return or(nearSet, profile.nearMm());
    }

    private static double or(@Nullable Double set, double usual) {
        return set == null ? usual : set;
    }

    void describe(ParameterTable table) {
        table.add(
                        Parameter.number("cruise", Unit.MM_PER_S, "how fast move goes")
                                .within(
                                        profile.slowestMmPerSec(),
                                        profile.speed().max()),
                        () -> Value.of(cruiseMmPerSec, Unit.MM_PER_S))
                .kept()
                .writes(values -> setCruise(values.get(0).number()));
        table.add(
                        Parameter.number("cruiseTurn", Unit.DEG_PER_S, "how fast turn goes")
                                .within(
                                        profile.slowestTurnDegPerSec(),
                                        profile.turn().max()),
                        () -> Value.of(cruiseTurnDegPerSec, Unit.DEG_PER_S))
                .kept()
                .writes(values -> setCruiseTurn(values.get(0).number()));
        table.add(
                        Parameter.number("maxMove", Unit.MM, "the longest single move that is accepted")
                                .within(1, 1_000_000),
                        () -> Value.of(maxMoveMm, Unit.MM))
                .kept()
                .writes(values -> maxMove(values.get(0).number()));
        table.add(
                        Parameter.number("near", Unit.MM, "the distance below which something counts as near")
                                .within(0, 10_000),
                        () -> Value.of(nearMm(), Unit.MM))
                .kept()
                .writes(values -> nearSet = values.get(0).number());
        table.add(
                        Parameter.onOff("guard", "whether move, turn and drive stop in front of obstacles"),
                        () -> Value.onOff(guarded))
                .kept()
                .writes(values -> guarded = values.get(0).isYes());
        table.add(
                        Parameter.onOff("giveWay", "whether it may be asked to make room for other robots"),
                        () -> Value.onOff(givesWay))
                .kept()
                .writes(values -> givesWay = values.get(0).isYes());
    }

    void checkMove(double mm) {
        double most = maxMoveMm;
        if (!Double.isFinite(mm)) {
            throw new ParameterException("move", "move " + mm + ": not a distance");
        }
        if (Math.abs(mm) > most) {
            throw new ParameterException(
                    "move",
                    "move " + Value.plain(mm) + ": longer than maxMove, " + Value.plain(most)
                            + " mm; set maxMove higher to allow it");
        }
    }

    void checkTurn(double degrees) {
        if (!Double.isFinite(degrees) || Math.abs(degrees) > MAX_TURN_DEG) {
            throw new ParameterException("turn", "turn " + shown(degrees) + ": not an angle of at most 36000 deg");
        }
    }

    private static String shown(double number) {
        return Double.isFinite(number) ? Value.plain(number) : String.valueOf(number);
    }

    void checkDrive(double mmPerSec, double degPerSec, double seconds) {
        checkDrive(mmPerSec, degPerSec);
        if (!(seconds > 0 && seconds <= MAX_DRIVE_SECONDS)) {
            throw new ParameterException(
                    "drive",
                    "drive … for " + Value.plain(seconds) + " s: outside 0 … " + Value.plain(MAX_DRIVE_SECONDS) + " s");
        }
    }

    void checkDrive(double mmPerSec, double degPerSec) {
        if (!profile.speed().contains(mmPerSec)) {
            throw new ParameterException(
                    "drive", "drive " + Value.plain(mmPerSec) + ": outside " + profile.speed() + " mm/s");
        }
        if (!profile.turn().contains(degPerSec)) {
            throw new ParameterException(
                    "drive", "drive … " + Value.plain(degPerSec) + ": outside " + profile.turn() + " deg/s");
        }
    }
}
