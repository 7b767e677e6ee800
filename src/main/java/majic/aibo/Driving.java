package majic.aibo;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * What {@code drive} makes of a speed and a turn rate: the dog has one gait at a time, so whichever dominates is walked,
 * at its speed as far as the legs can, in short pieces, each begun when the one before has ended, as long as somebody drives. Nothing here waits.
 */
final class Driving {
    private static final double PIECE_MS = 600;

    /** A drive is renewed at least this often; what is older is forgotten even if nobody says so, seconds. */
    private static final double LEASE_S = 0.7;

    private final AiboSession session;
    private final Consumer<String> notice;
    private volatile @Nullable Stride wanted;
    private volatile long renewedNanos;
    private volatile @Nullable Gait announced;
    private @Nullable Running rising;

    Driving(AiboSession session, Consumer<String> notice) {
        this.session = session;
        this.notice = notice;
    }

    /** Takes over what is wanted from now on; the motion lock is held. */
    void drive(double mmPerSec, double degPerSec) {
        Stride stride = choose(mmPerSec, degPerSec);
        if (stride != null && session.runner().current() == null) {
            session.feet().refuseFallen(session.dog().senses().posture());
        }
        renewedNanos = session.watch().time().nanos();
        wanted = stride;
        if (stride == null) {
            session.halt();
            return;
        }
        announce(stride.gait());
        tend();
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

    /** Nobody drives any more; what has been started is stopped by whoever says so. */
    void forget() {
        wanted = null;
        announced = null;
    }

    /** Begins the next piece if it is time, or ends one that is no longer wanted. */
    void tend() {
        Stride stride = wanted;
        if (stride == null) {
            return;
        }
        if (session.watch().time().secondsSince(renewedNanos) > LEASE_S || session.isSilent()) {
            session.halt();
            return;
        }
        Running running = session.runner().current();
        if (running == null) {
            begin(stride);
        } else if (running.piece() != null && running.piece().gait() != stride.gait() && !running.isStopRequested()) {
            session.runner().halt(session.sweep().halt());
        }
    }

    private synchronized void begin(Stride stride) {
        if (session.runner().current() != null) {
            return;
        }
        settleRising();
        Running rise = session.feet().rise();
        if (rise != null) {
            rising = rise;
            session.runner().start(rise, this::isWanted);
            return;
        }
        session.guard().renew();
        Running piece = session.runner().piece(stride, PIECE_MS / stride.msPerUnit());
        if (session.runner().start(piece, this::isWanted) && stride.gait() == Gait.FORWARD) {
            session.sweep().start();
        }
    }

    private void settleRising() {
        Running risen = rising;
        rising = null;
        if (risen != null && risen.isOver()) {
            boolean risenWell = risen.failure() == null && !risen.isStopRequested();
            session.dog().senses().assumeMotors(risenWell);
            session.dog().setAfoot(risenWell);
            if (!risenWell) {
                forget();
            }
        }
    }

    private boolean isWanted() {
        return wanted != null;
    }
}
