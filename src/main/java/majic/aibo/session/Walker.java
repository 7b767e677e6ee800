package majic.aibo.session;

import java.util.Objects;
import majic.aibo.body.DogState;
import majic.aibo.body.Gait;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Stride;
import majic.aibo.urbi.DogClock;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.RobotWait;
import org.jspecify.annotations.Nullable;

/**
 * Walks distances and turns angles: one piece of a gait after the other, none longer than two seconds, each begun when
 * the dog has reported the end of the one before. Thread-safe; {@code MajicBot} runs one motion at a time.
 */
public final class Walker {
    /** An engine may answer two seconds late, and a gait may last two cycles longer than commanded. */
    private static final double LATE_S = 3;

    private final GaitControl gaits;
    private final PostureControl postures;
    private final DogState dog;
    private final DogClock clock;
    private final RobotWait waiting;

    Walker(GaitControl gaits, PostureControl postures, DogState dog, DogClock clock, RobotWait waiting) {
        this.gaits = gaits;
        this.postures = postures;
        this.dog = dog;
        this.clock = clock;
        this.waiting = waiting;
    }

    /** Makes the dog stand with its motors on; takes up to five seconds if it does not stand yet. */
    void stand(Motion motion) {
        postures.stand(motion);
    }

    /**
     * Covers an amount; blocks until the dog has ended it.
     *
     * @param amount mm or degrees, positive
     * @return the amount covered, with the sign of the gait
     * @throws MotionFailed if the dog must not or does not walk on; the message says how far it came
     * @throws LinkLost if the connection was lost; the message says how far it came by then
     */
    public double cover(Stride stride, double amount, Motion motion) {
        return new Walk(stride, motion).cover(amount);
    }

    /** One motion, on the thread that runs it. */
    private final class Walk {
        private final Stride stride;
        private final Motion motion;
        private double coveredBefore;
        private @Nullable RunningMotion current;

        Walk(Stride stride, Motion motion) {
            this.stride = stride;
            this.motion = motion;
        }

        double cover(double amount) {
            motion.pause(0);
            if (motion.guardReached() || amount == 0) {
                return 0;
            }
            stand(motion);
            try {
                walkAll(amount);
            } catch (LinkLost e) {
                String done = stride.gait().isWalk() ? "come " : "turned ";
                throw new LinkLost(e.getMessage() + "; by then it had " + done + distance(), e);
            }
            return covered();
        }

        private void walkAll(double amount) {
            if (stride.gait() == Gait.FORWARD) {
                startSweep();
            }
            double durationMs = amount * stride.msPerUnit();
            int pieces = (int) Math.ceil(durationMs / GaitPiece.LONGEST_MS);
            for (int piece = 0; piece < pieces && !motion.guardReached(); piece++) {
                walk(amount / pieces);
            }
            motion.send(gaits.sweep()::end);
        }

        /** The head sweeps while the dog walks ahead; with a guard condition the walk begins after one whole sweep. */
        private void startSweep() {
            motion.send(gaits.sweep()::start);
            if (motion.isGuarded()) {
                motion.pause(HeadSweep.PERIOD_S + clock.roundTripS());
            }
        }

        private void walk(double amount) {
            gaits.executor().awaitFree(motion);
            failOn(gaits.trouble());
            motion.send(gaits::armGuard);
            RunningMotion running = gaits.piece(stride, amount);
            GaitPiece piece = Objects.requireNonNull(running.piece());
            coveredBefore = covered();
            current = running;
            motion.send(() -> gaits.start(running, () -> true));
            motion.await(() -> running.isOver() || gaits.trouble() != null, piece.durationMs() / 1000 + LATE_S);
            motion.check();
            checkEnd(running, piece);
        }

        /**
         * Checks how a piece has ended, and ends one that is not over: at a guard condition, in trouble, or overdue.
         */
        private void checkEnd(RunningMotion running, GaitPiece piece) {
            String trouble = trouble(running);
            if (!running.isOver()) {
                end(running);
            }
            failOn(trouble);
            if (!running.isOver()) {
                failOn(GaitControl.OVERDUE);
            } else if (!running.isStopRequested()) {
                failOn(piece.flaw());
            } else if (!motion.guardReached()) {
                failOn(MotionExecutor.STOPPED);
            }
        }

        /** Stops a piece and waits for its end, so that it is known how far the dog came. */
        private void end(RunningMotion running) {
            motion.send(() -> gaits.executor().halt(""));
            waiting.await(running::isOver, LATE_S);
            motion.check();
        }

        private @Nullable String trouble(RunningMotion running) {
            String failure = running.failure();
            return failure == null ? gaits.trouble() : Gait.refusal(failure);
        }

        private void failOn(@Nullable String why) {
            if (why != null) {
                throw new MotionFailed(why + ", after " + distance());
            }
        }

        private Value distance() {
            return Value.about(Math.rint(covered()), stride.gait().isWalk() ? Unit.MM : Unit.DEG);
        }

        /** How far it has come, at the time of the newest reading, as the estimated pose has it. */
        private double covered() {
            GaitPiece piece = current == null ? null : current.piece();
            if (piece == null) {
                return coveredBefore;
            }
            return coveredBefore + (current.isOver() ? piece.covered() : piece.coveredAt(dog.sensedMs()));
        }
    }
}
