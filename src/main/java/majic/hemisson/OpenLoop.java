package majic.hemisson;

import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/** One timed motion (Hemisson sheet 13), on the thread of whoever wants it. */
final class OpenLoop {
    private final MajicHemisson bot;
    private final Overseer overseer;
    private final Motion motion;

    OpenLoop(MajicHemisson bot, Overseer overseer, Motion motion) {
        this.bot = bot;
        this.overseer = overseer;
        this.motion = motion;
    }

    /** Drives a leg, or as much of it as the guard allows; the robot stands afterwards. */
    Value run(Leg leg) {
        if (leg.seconds() <= 0 || !mayBegin()) {
            return leg.covered(0);
        }
        Exchange start = begin(leg);
        long due = start.middleNanos() + (long) (leg.seconds() * 1e9) - start.roundTripNanos() / 2;
        overseer.motionEnds(due);
        motion.await(() -> overseer.trouble() != null, (due - bot.nanos()) / 1e9);
        motion.send(bot::halt);
        bot.confirmHalt();
        failOn(overseer.trouble());
        return leg.covered((overseer.track().sinceNanos() - start.middleNanos()) / 1e9);
    }

    /** Looks where it stands now, so that a guard that holds already lets it stand. */
    private boolean mayBegin() {
        Proximity before = overseer.seen();
        Exchange look = bot.conversation().ask(Question.PROXIMITY);
        bot.await(() -> look.failure() != null || (look.isDone() && overseer.seen() != before));
        motion.check();
        failOn(look.failure());
        return motion.pause(0);
    }

    /** The motion counts from the answer, less half of what the exchange took. */
    private Exchange begin(Leg leg) {
        Exchange[] start = new Exchange[1];
        motion.send(() -> {
            overseer.motionBegins(bot.nanos() + (long) (leg.seconds() * 1e9));
            start[0] = bot.conversation().ask(Question.wheels(leg.wheels()));
        });
        bot.await(start[0]::isDone);
        motion.check();
        failOn(start[0].failure());
        return start[0];
    }

    private void failOn(@Nullable String trouble) {
        if (trouble != null) {
            throw new MotionFailed(trouble);
        }
    }
}
