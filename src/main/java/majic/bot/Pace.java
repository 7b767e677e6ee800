package majic.bot;

import org.jspecify.annotations.Nullable;

/** The settable limits of one robot's motions. Thread-safe. */
final class Pace {
    private static final double MAX_MOVE_MM = 5000;
    private static final double MAX_DRIVE_SECONDS = 60;

    private final BotProfile profile;
    private volatile double maxMoveMm = MAX_MOVE_MM;

    /** The value that was set; null for the value of the profile. */
    private volatile @Nullable Double wantedCruise;

    private volatile @Nullable Double wantedCruiseTurn;
    private volatile @Nullable Double wantedNear;

    Pace(BotProfile profile) {
        this.profile = profile;
    }

    /** The same with another profile; what was set stays, as far as the robot can do it. */
    Pace fittedTo(BotProfile better) {
        Pace fitted = new Pace(better);
        fitted.maxMoveMm = maxMoveMm;
        fitted.wantedCruise = wantedCruise;
        fitted.wantedCruiseTurn = wantedCruiseTurn;
        fitted.wantedNear = wantedNear;
        return fitted;
    }

    double cruiseMmPerSec() {
        return profile.speed().clamp(or(wantedCruise, profile.cruiseMmPerSec()));
    }

    double cruiseTurnDegPerSec() {
        return profile.turn().clamp(or(wantedCruiseTurn, profile.cruiseTurnDegPerSec()));
    }

    private double nearMm() {
        return or(wantedNear, profile.nearMm());
    }

    private static double or(@Nullable Double wanted, double usual) {
        return wanted == null ? usual : wanted;
    }

    void describe(ParameterTable table) {
        table.add(
                        Parameter.number("cruise", Unit.MM_PER_S, "how fast move goes")
                                .within(
                                        profile.slowestMmPerSec(),
                                        profile.speed().max()),
                        () -> Value.of(cruiseMmPerSec(), Unit.MM_PER_S))
                .writes(values -> wantedCruise = values.get(0).number());
        table.add(
                        Parameter.number("cruiseTurn", Unit.DEG_PER_S, "how fast turn goes")
                                .within(
                                        profile.slowestTurnDegPerSec(),
                                        profile.turn().max()),
                        () -> Value.of(cruiseTurnDegPerSec(), Unit.DEG_PER_S))
                .writes(values -> wantedCruiseTurn = values.get(0).number());
        table.add(
                        Parameter.number("maxMove", Unit.MM, "the longest single move that is accepted")
                                .within(1, 1_000_000),
                        () -> Value.of(maxMoveMm, Unit.MM))
                .writes(values -> maxMoveMm = values.get(0).number());
        table.add(
                        Parameter.number("near", Unit.MM, "what counts as close for this robot")
                                .within(0, 10_000),
                        () -> Value.of(nearMm(), Unit.MM))
                .writes(values -> wantedNear = values.get(0).number());
    }

    void checkMove(double mm) {
        checkMove(mm, maxMoveMm);
    }

    static void checkMove(double mm, double maxMoveMm) {
        if (!Double.isFinite(mm)) {
            throw new ParameterException("move", "move " + mm + ": not a distance");
        }
        if (Math.abs(mm) > maxMoveMm) {
            throw new ParameterException(
                    "move",
                    "move " + Value.plain(mm) + ": longer than maxMove, " + Value.plain(maxMoveMm)
                            + " mm; set maxMove higher to allow it");
        }
    }

    static void checkTurn(double degrees) {
        if (!Double.isFinite(degrees) || Math.abs(degrees) > 36_000) {
            throw new ParameterException("turn", "turn " + shown(degrees) + ": not an angle of at most 36000 deg");
        }
    }

    private static String shown(double number) {
        return Double.isFinite(number) ? Value.plain(number) : String.valueOf(number);
    }

    static void checkDrive(BotProfile profile, double mmPerSec, double degPerSec) {
        if (!profile.speed().contains(mmPerSec)) {
            throw new ParameterException(
                    "drive", "drive " + Value.plain(mmPerSec) + ": outside " + profile.speed() + " mm/s");
        }
        if (!profile.turn().contains(degPerSec)) {
            throw new ParameterException(
                    "drive", "drive … " + Value.plain(degPerSec) + ": outside " + profile.turn() + " deg/s");
        }
    }

    static void checkDriveTime(double seconds) {
        if (!(seconds > 0 && seconds <= MAX_DRIVE_SECONDS)) {
            throw new ParameterException(
                    "drive",
                    "drive … for " + Value.plain(seconds) + " s: outside 0 … " + Value.plain(MAX_DRIVE_SECONDS) + " s");
        }
    }
}
