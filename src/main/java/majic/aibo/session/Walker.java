package majic.aibo.session;

import java.util.Objects;
import majic.aibo.body.DogState;
import majic.aibo.body.Gait;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Stride;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * Walks a distance or turns an angle: one piece of a gait after the other, none longer than two seconds, each begun when
 * the dog has reported the end of the one before. Used for one motion.
 */
public final class Walker {
    /** A slow engine answers two seconds late, and a gait may last two cycles longer than ordered. */
    private static final double LATE_S = 3;

    private final AiboSession session;
    private final DogState dog;
    private final Motion motion;
    private double covered;

    public Walker(AiboSession session, Motion motion) {
        this.session = session;
        this.dog = session.dog();
        this.motion = motion;
    }

    /** Covers an amount, mm or degrees, always positive; returns the amount covered, with the gait's sign. */
    public double cover(Stride stride, double amount) {
        motion.pause(0);
        if (motion.guardReached() || amount == 0) {
            return 0;
        }
        session.postures().stand(motion);
        if (stride.gait() == Gait.FORWARD) {
            lookAhead();
        }
        double durationMs = amount * stride.msPerUnit();
        int pieces = (int) Math.ceil(durationMs / GaitPiece.LONGEST_MS);
        for (int piece = 0; piece < pieces && !motion.guardReached(); piece++) {
            walk(stride, amount / pieces);
        }
        motion.send(session.sweep()::end);
        return covered;
    }

    /** The head sweeps while the dog walks ahead; if something is to stop it, a whole look is taken in before. */
    private void lookAhead() {
        motion.send(session.sweep()::start);
        if (motion.isGuarded()) {
            motion.pause(HeadSweep.PERIOD_S + session.clock().roundTripS());
        }
    }

    private void walk(Stride stride, double amount) {
        session.awaitFree(motion);
        motion.send(session.guard()::renew);
        RunningMotion running = session.executor().piece(stride, amount);
        GaitPiece piece = Objects.requireNonNull(running.piece());
        motion.send(() -> session.executor().start(running, () -> true));
        motion.await(() -> running.isOver() || trouble() != null, piece.durationMs() / 1000 + LATE_S);
        settle(running, piece);
        covered += piece.covered();
        if (piece.isCutShort() && !running.isStopRequested()) {
            throw failed("another program, or its guard, ended the walk", piece.gait());
        }
    }

    /** The piece is over, or has to be. */
    private void settle(RunningMotion running, GaitPiece piece) {
        motion.check();
        String failure = running.failure();
        String trouble = failure == null ? trouble() : Gait.refusal(failure);
        if (trouble != null) {
            covered += piece.coveredAt(Math.round(session.clock().estimateMs()));
            throw failed(trouble, piece.gait());
        }
        if (!running.isOver()) {
            motion.send(() -> session.executor().halt(""));
            boolean ended = session.waiting().await(running::isOver, LATE_S);
            motion.check();
            if (!ended || !motion.guardReached()) {
                throw failed("the dog did not tell the end of its walk in time; it was told to stop", piece.gait());
            }
        }
    }

    private MotionFailed failed(String why, Gait gait) {
        Unit unit = gait.isWalk() ? Unit.MM : Unit.DEG;
        return new MotionFailed(why + ", after " + Value.about(Math.rint(covered), unit));
    }

    private @Nullable String trouble() {
        return session.isSilent()
                ? "no word from the dog for 1.5 s; it was told to stop"
                : dog.senses().unfit();
    }
}
