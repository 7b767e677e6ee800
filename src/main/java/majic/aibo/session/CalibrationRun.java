package majic.aibo.session;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.aibo.body.Calibration;
import majic.aibo.body.Gait;
import majic.aibo.body.Stride;
import majic.bot.Range;
import majic.bot.Unit;
import majic.driver.CalibrateCommand;
import majic.driver.CalibrateCommand.Trial;
import majic.driver.Motion;

/** Calibrates one gait: the dog walks or turns for a known time, and the user measures how far it came. */
public final class CalibrationRun implements CalibrateCommand.CalibratedRobot {
    /** About a metre. */
    private static final int WALK_S = 12;

    /** About a whole turn. */
    private static final int TURN_S = 10;

    private final Supplier<Walker> walker;
    private final Calibration calibration;
    private final Function<Gait, Stride> stride;
    private final Learner learner;

    /** Receives a new factor. */
    @FunctionalInterface
    public interface Learner {
        /** Keeps the milliseconds for one mm or one degree of a gait at the usual pace of the legs. */
        void learn(Gait gait, double msPerUnit);
    }

    /**
     * Moves nothing yet.
     *
     * @param walker of the open connection; throws if there is none
     * @param stride the stride that moves use now; the result holds for every pace
     */
    public CalibrationRun(
            Supplier<Walker> walker, Calibration calibration, Function<Gait, Stride> stride, Learner learner) {
        this.walker = walker;
        this.calibration = calibration;
        this.stride = stride;
        this.learner = learner;
    }

    @Override
    public List<String> directions() {
        return Arrays.stream(Gait.values()).map(Gait::key).toList();
    }

    @Override
    public Trial go(String direction, Motion motion) {
        Gait gait = Gait.of(direction);
        Walker walking = walker.get();
        walking.stand(motion);
        letMark(gait, motion);
        Stride stride = this.stride.apply(gait);
        double amount = seconds(gait) * stride.unitsPerSecond();
        double covered = Math.abs(walking.cover(stride, amount, motion));
        double usualMs = covered * stride.usualMsPerUnit();
        Range sensible = Calibration.range(gait);
        Range credible = new Range(usualMs / sensible.max(), usualMs / sensible.min());
        return new Trial(covered, unit(gait), credible, measured -> learn(gait, usualMs / measured));
    }

    private static void letMark(Gait gait, Motion motion) {
        if (gait.isWalk()) {
            CalibrateCommand.letMark(
                    motion,
                    "where its fore paws stand",
                    "walks " + gait.key() + " for " + WALK_S + " s, about 1 m: keep the way free");
        } else {
            CalibrateCommand.letMark(
                    motion, "which way it looks", "turns " + gait.key() + " for " + TURN_S + " s, about a whole turn");
        }
    }

    private String learn(Gait gait, double now) {
        double old = calibration.msPerUnit(gait);
        learner.learn(gait, now);
        return String.format(
                Locale.ROOT,
                "%s took %.2f ms for a %s before, takes %.2f ms now; kept for this dog",
                gait.key(),
                old,
                unit(gait).symbol(),
                now);
    }

    private static int seconds(Gait gait) {
        return gait.isWalk() ? WALK_S : TURN_S;
    }

    private static Unit unit(Gait gait) {
        return gait.isWalk() ? Unit.MM : Unit.DEG;
    }
}
