package majic.figures.nav;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;

/** How far the place that a robot has on a map is from the truth of the lab. */
final class PlaceErrors {
    private final MajicBot robot;
    private final List<Double> mm = new ArrayList<>();
    private final List<Double> degrees = new ArrayList<>();
    private Pose lastTruth;
    private long lastNanos;
    private int lost;

    /** Begins where the robot stands. */
    PlaceErrors(MajicBot robot, Pose truth) {
        this.robot = robot;
        this.lastTruth = truth;
        this.lastNanos = robot.time().nanos();
    }

    /** Compares the newest pose of the robot with where it was when it reported that. */
    void add(Pose truth) {
        long now = robot.time().nanos();
        BotState state = robot.state();
        double share = now == lastNanos ? 1 : Math.max(0, (double) (state.atNanos() - lastNanos) / (now - lastNanos));
        Pose way = truth.seenFrom(lastTruth);
        Pose then = lastTruth.plus(new Pose(share * way.xMm(), share * way.yMm(), share * way.headingDeg()));
        mm.add(state.pose().distanceMm(then));
        degrees.add(Math.abs(state.pose().seenFrom(then).headingDeg()));
        lost += robot.uncertainty().isKnown() ? 0 : 1;
        lastTruth = truth;
        lastNanos = now;
    }

    /** Returns median, 95 of 100 and largest error, and the share of the time in which the place was unknown. */
    String text() {
        return String.format(
                Locale.ROOT,
                "%s | %s | %.1f %%",
                text(mm, "%.0f / %.0f / %.0f mm"),
                text(degrees, "%.1f / %.1f / %.1f deg"),
                100.0 * lost / mm.size());
    }

    private static String text(List<Double> errors, String format) {
        List<Double> sorted = errors.stream().sorted().toList();
        int last = sorted.size() - 1;
        return String.format(Locale.ROOT, format, sorted.get(last / 2), sorted.get(last * 95 / 100), sorted.get(last));
    }
}
