package majic.hemisson;

import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/** One timed motion (Hemisson sheet 13), on the thread of whoever wants it. */
final class OpenLoop {
    private final MajicHemisson bot;
    private final MotionWatch watch;
    private final Motion motion;

    OpenLoop(MajicHemisson bot, Motion motion) {
        this.bot = bot;
        this.watch = bot.overseer().motion();
        this.motion = motion;
    }

    /** Drives a leg, or as much of it as the guard allows; the robot stands afterwards. */
    Value run(Leg leg) {
        if (leg.seconds() <= 0 || !mayBegin()) {
            return leg.covered(0);
        }
        Exchange start = begin(leg);
        long due = start.middleNanos() + nanos(leg.seconds()) - start.roundTripNanos() / 2;
        watch.ends(due);
        goOn(leg, start.middleNanos(), due);
        motion.send(bot::halt);
        bot.confirmHalt();
        failOn(watch.trouble());
        return leg.covered((bot.overseer().reckoning().track().sinceNanos() - start.middleNanos()) / 1e9);
    }

    /** Looks where it stands now, so that a guard that holds already lets it stand. */
    private boolean mayBegin() {
        bot.refuseContrary();
        Proximity before = bot.overseer().seen();
        Exchange look = bot.conversation().ask(Question.PROXIMITY);
        bot.answers()
                .await(() -> look.failure() != null
                        || (look.isDone() && bot.overseer().seen() != before));
        motion.check();
        failOn(look.failure());
        return motion.pause(0);
    }

    /** The motion counts from the answer, less half of what the exchange took. */
    private Exchange begin(Leg leg) {
        Exchange[] start = new Exchange[1];
        motion.send(() -> {
            watch.begins(bot.nanos() + nanos(leg.seconds()));
            start[0] = bot.conversation().ask(Question.wheels(leg.wheels()));
        });
        bot.answers().await(start[0]::isDone);
        motion.check();
        failOn(start[0].failure());
        return start[0];
    }

    /** Lets the time pass, and eases the faster wheel at the end of each round. */
    private void goOn(Leg leg, long begunNanos, long dueNanos) {
        long round = leg.rounds() == 0 ? 0 : (dueNanos - begunNanos) / leg.rounds();
        for (int count = 0; count < leg.rounds(); count++) {
            long roundNanos = begunNanos + count * round;
            if (count > 0) {
                tell(leg.wheels());
            }
            if (!lasts(roundNanos + (long) (round * (1 - leg.easedShare())))) {
                return;
            }
            tell(leg.eased());
            if (count < leg.rounds() - 1 && !lasts(roundNanos + round)) {
                return;
            }
        }
        lasts(dueNanos);
    }

    private void tell(Wheels wheels) {
        motion.send(() -> bot.conversation().ask(Question.wheels(wheels)));
    }

    /** Waits for a moment; false if something ends the motion before. */
    private boolean lasts(long untilNanos) {
        boolean met = motion.await(() -> watch.trouble() != null, (untilNanos - bot.nanos()) / 1e9);
        return !met && !motion.guardReached();
    }

    private void failOn(@Nullable String trouble) {
        if (trouble != null) {
            throw new MotionFailed(trouble);
        }
    }

    private static long nanos(double seconds) {
        return (long) (seconds * 1e9);
    }
}
