package majic.aibo;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.CalibrateCommand;
import majic.bot.CalibrateCommand.Trial;
import majic.bot.Motion;
import majic.bot.Range;
import majic.bot.Unit;

/** How the dog is taught its pace: it walks or turns for a known time, and somebody measures how far it came. */
final class Lesson implements CalibrateCommand.Pupil {
    /** About a metre. */
    private static final int WALK_S = 12;

    /** About a whole turn. */
    private static final int TURN_S = 10;

    /** For putting a mark on the floor. */
    private static final int MARKING_S = 5;

    private final Supplier<AiboSession> session;
    private final Function<Gait, Stride> stride;
    private final Learner learner;

    /** Who takes a new factor over. */
    @FunctionalInterface
    interface Learner {
        /** Keeps the milliseconds for one mm or one degree of a gait at the usual pace of the legs. */
        void learn(Gait gait, double msPerUnit);
    }

    /** Goes in the stride that moves have now; what is learned holds for every pace. */
    Lesson(Supplier<AiboSession> session, Function<Gait, Stride> stride, Learner learner) {
        this.session = session;
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
        AiboSession open = session.get();
        open.feet().stand(motion);
        open.say(announcement(gait));
        motion.pause(MARKING_S);
        Stride stride = this.stride.apply(gait);
        double amount = seconds(gait) * stride.unitsPerSecond();
        double covered = Math.abs(new Walker(open, motion).cover(stride, amount));
        double usualMs = covered * stride.usualMsPerUnit();
        return new Trial(covered, unit(gait), measured -> learn(gait, usualMs, measured));
    }

    private static String announcement(Gait gait) {
        return gait.isWalk()
                ? "mark where its fore paws stand; in " + MARKING_S + " s it walks " + gait.key() + " for " + WALK_S
                        + " s, about 1 m: keep the way free"
                : "mark which way it looks; in " + MARKING_S + " s it turns " + gait.key() + " for " + TURN_S
                        + " s, about a whole turn";
    }

    private String learn(Gait gait, double usualMs, double measured) {
        double old = session.get().dog().calibration().msPerUnit(gait);
        double now = usualMs / measured;
        Range sensible = Calibration.range(gait);
        if (!sensible.contains(now)) {
            throw new BotException(String.format(
                    Locale.ROOT,
                    "calibrate %s %.0f%s: no dog goes so far or so little in that time; between %.0f and %.0f %s would do",
                    gait.key(),
                    measured,
                    unit(gait).symbol(),
                    usualMs / sensible.max(),
                    usualMs / sensible.min(),
                    unit(gait).symbol()));
        }
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
