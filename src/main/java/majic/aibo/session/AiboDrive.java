package majic.aibo.session;

import java.util.function.Consumer;
import majic.aibo.body.Calibration;
import majic.aibo.body.Gait;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Stride;
import majic.bot.MotionFailed;
import org.jspecify.annotations.Nullable;

/**
 * What {@code drive} makes of a speed and a turn rate: the dog has one gait at a time, so whichever dominates is walked,
 * at its speed as far as the legs can, in short pieces, each begun when the one before has ended, as long as the
 * drive is renewed. An error ends it, and is thrown at the next renewal. Nothing here waits.
 */
public final class AiboDrive {
    private static final double PIECE_MS = 600;

    /** A drive is renewed more often; one that is older ends, and does not go on when it is renewed later, seconds. */
    private static final double LEASE_S = 1;

    private static final String LATE = "the drive was not renewed in time; the dog was told to stop";

    /** A piece and the two seconds that a slow engine is late, with something to spare. */
    private static final double OVERDUE_S = PIECE_MS / 1000 + 3;

    private final AiboSession session;
    private final Consumer<String> notice;
    private volatile @Nullable Stride wanted;
    private volatile @Nullable String failure;
    private volatile long renewedNanos;
    private volatile @Nullable Gait announced;
    private volatile boolean underWay;
    private volatile long begunNanos;
    private @Nullable RunningMotion latest;

    AiboDrive(AiboSession session, Consumer<String> notice) {
        this.session = session;
        this.notice = notice;
    }

    /**
     * Takes over what is wanted from now on; the motion lock is held.
     *
     * @throws MotionFailed if this drive has gone wrong since it was last renewed; the dog was stopped
     */
    public void drive(double mmPerSec, double degPerSec) {
        Stride stride = choose(mmPerSec, degPerSec);
        if (hasLapsed()) {
            fail(LATE);
        }
        refuseAfterFailure();
        if (stride != null && session.executor().current() == null) {
            session.postures().refuseFallen(session.dog().senses().posture());
        }
        renewedNanos = session.waiting().time().nanos();
        wanted = stride;
        if (stride == null) {
            session.halt();
            return;
        }
        announce(stride.gait());
        tend();
    }

    private void refuseAfterFailure() {
        String wrong = failure;
        if (wrong != null) {
            forget();
            throw new MotionFailed(wrong);
        }
    }

    private @Nullable Stride choose(double mmPerSec, double degPerSec) {
        Calibration calibration = session.dog().calibration();
        double walk =
                Math.abs(mmPerSec) / calibration.stride(Gait.walking(mmPerSec)).unitsPerSecond();
        double turn = Math.abs(degPerSec)
                / calibration.stride(Gait.turning(degPerSec)).unitsPerSecond();
        if (walk == 0 && turn == 0) {
            return null;
        }
        return walk >= turn
                ? calibration.strideAt(Gait.walking(mmPerSec), Math.abs(mmPerSec))
                : calibration.strideAt(Gait.turning(degPerSec), Math.abs(degPerSec));
    }

    private void announce(Gait gait) {
        if (gait != announced) {
            announced = gait;
            notice.accept("drives with its gait " + (gait.isWalk() ? "straight " : "on the spot ") + gait.key());
        }
    }

    /** Ends the drive without sending anything; the caller stops what has been started. */
    void forget() {
        wanted = null;
        announced = null;
        failure = null;
        underWay = false;
    }

    /** Begins the next piece if it is time, or ends one that is no longer wanted. */
    void tend() {
        Stride stride = wanted;
        if (stride == null) {
            return;
        }
        if (hasLapsed()) {
            fail(LATE);
            return;
        }
        RunningMotion running = session.executor().current();
        String wrong = trouble(running);
        if (wrong != null) {
            fail(wrong);
        } else if (running == null) {
            begin(stride);
        } else if (running.piece() != null && running.piece().gait() != stride.gait() && !running.isStopRequested()) {
            session.executor().halt(session.sweep().halt());
        }
    }

    /** Whether the drive was not renewed in time, as when the program was suspended. */
    private boolean hasLapsed() {
        return wanted != null && session.waiting().time().secondsSince(renewedNanos) > LEASE_S;
    }

    private void fail(String wrong) {
        session.halt();
        failure = wrong;
    }

    /** Whether the drive must not go on; motors that are off before it has begun are switched on by it. */
    private @Nullable String trouble(@Nullable RunningMotion running) {
        if (session.isSilent()) {
            return "no word from the dog for 1.5 s; it was told to stop";
        }
        boolean walks = running != null && running.piece() != null;
        if (walks && session.waiting().time().secondsSince(begunNanos) > OVERDUE_S) {
            return "the dog did not tell the end of its walk in time; it was told to stop";
        }
        return underWay ? session.dog().senses().unfit() : null;
    }

    private synchronized void begin(Stride stride) {
        if (session.executor().current() != null) {
            return;
        }
        String wrong = settle();
        if (wrong != null) {
            fail(wrong);
            return;
        }
        RunningMotion rise = underWay ? null : session.postures().rise();
        if (rise != null) {
            latest = rise;
            session.executor().start(rise, this::isWanted);
            return;
        }
        walk(stride);
    }

    private void walk(Stride stride) {
        underWay = true;
        session.guard().renew();
        RunningMotion piece = session.executor().piece(stride, PIECE_MS / stride.msPerUnit());
        latest = piece;
        begunNanos = session.waiting().time().nanos();
        if (session.executor().start(piece, this::isWanted) && stride.gait() == Gait.FORWARD) {
            session.sweep().start();
        }
    }

    /** Looks at how the latest thing that was started has ended; returns what was wrong with it. */
    private @Nullable String settle() {
        RunningMotion ended = latest;
        latest = null;
        if (ended == null || ended.isStopRequested()) {
            return null;
        }
        String refusal = ended.failure();
        if (refusal != null) {
            return Gait.refusal(refusal);
        }
        GaitPiece piece = ended.piece();
        if (piece == null) {
            session.dog().senses().assumeMotors(true, ended.endedMs());
            session.dog().setAfoot(true);
            return null;
        }
        return piece.isCutShort() ? "another program, or its guard, ended the walk" : null;
    }

    private boolean isWanted() {
        return wanted != null;
    }
}
