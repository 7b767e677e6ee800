package majic.aibo;

import java.util.Objects;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import org.jspecify.annotations.Nullable;

/** Walks a distance or turns an angle: one piece of a gait after the other, none longer than two seconds. */
final class Walker {
    private static final double LATE_S = 2;

    private final AiboSession session;
    private final Dog dog;
    private final Motion motion;

    Walker(AiboSession session, Motion motion) {
        this.session = session;
        this.dog = session.dog();
        this.motion = motion;
    }

    /** Covers an amount, mm or degrees, always positive; tells how much it was, with the gait's sign. */
    double cover(Stride stride, double amount) {
        motion.pause(0);
        if (motion.guardReached() || amount == 0) {
            return 0;
        }
        session.feet().stand(motion);
        if (stride.gait() == Gait.FORWARD) {
            lookAhead();
        }
        double durationMs = amount * stride.msPerUnit();
        int pieces = (int) Math.ceil(durationMs / Piece.LONGEST_MS);
        double covered = 0;
        for (int piece = 0; piece < pieces && !motion.guardReached(); piece++) {
            covered += walk(stride, amount / pieces);
        }
        motion.send(session.sweep()::end);
        return covered;
    }

    /** The head sweeps while the dog walks ahead; if something is to stop it, it has a whole look first. */
    private void lookAhead() {
        motion.send(session.sweep()::start);
        if (motion.isGuarded()) {
            motion.pause(HeadSweep.PERIOD_S);
        }
    }

    private double walk(Stride stride, double amount) {
        session.awaitFree(motion);
        motion.send(session.guard()::renew);
        Running running = session.runner().piece(stride, amount);
        Piece piece = Objects.requireNonNull(running.piece());
        motion.send(() -> session.runner().start(running, () -> true));
        motion.await(() -> running.isOver() || trouble() != null, piece.durationMs() / 1000 + LATE_S);
        settle(running);
        return piece.covered();
    }

    /** The piece is over, or has to be. */
    private void settle(Running running) {
        motion.check();
        String failure = running.failure();
        String trouble = failure == null ? trouble() : refusal(failure);
        if (trouble != null) {
            throw new MotionFailed(trouble);
        }
        if (!running.isOver()) {
            motion.send(() -> session.runner().halt(""));
            if (!session.watch().await(running::isOver, LATE_S)) {
                throw new MotionFailed("the dog did not tell the end of its walk in time; it was told to stop");
            }
            motion.check();
        }
    }

    private static String refusal(String failure) {
        return failure.contains("function") || failure.contains("robot.")
                ? "the stick in the dog has no such gait (" + failure + ")"
                : "the dog refuses: " + failure;
    }

    private @Nullable String trouble() {
        if (session.isSilent()) {
            return "no word from the dog for 1.5 s; it was told to stop";
        }
        return dog.senses().motorsOn().orElse(true) ? null : "the dog's motors were switched off";
    }
}
