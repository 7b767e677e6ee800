package majic.aibo.session;

import java.util.function.Consumer;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.aibo.body.Gait;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Stride;
import majic.bot.MotionFailed;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Drives the dog at a speed or a turn rate. The dog has one gait at a time, so it uses the gait of the greater part, at
 * that speed as far as the legs allow, in short pieces. Each piece begins when the one before has ended, as long as the
 * drive is renewed. An error ends the drive and is thrown at the next renewal. Never blocks.
 */
public final class AiboDrive {
    private static final double PIECE_MS = 600;

    /** A drive is renewed more often; one that is older ends, and does not go on when it is renewed later, seconds. */
    private static final double LEASE_S = 1;

    private static final String LATE = "the drive was not renewed in time; MAJIC stopped the dog";

    /** A piece and the two seconds that a slow engine is late, with something to spare. */
    private static final double OVERDUE_S = PIECE_MS / 1000 + 3;

    private final GaitControl gaits;
    private final PostureControl postures;
    private final DogState dog;
    private final TimeSource time;
    private final Consumer<String> notice;
    private volatile @Nullable Stride wanted;
    private volatile @Nullable String failure;
    private volatile @Nullable String failureOfEnded;
    private volatile long renewedNanos;
    private volatile @Nullable Gait announced;
    private volatile boolean underWay;
    private volatile long begunNanos;
    private @Nullable RunningMotion latest;

    AiboDrive(GaitControl gaits, PostureControl postures, DogState dog, TimeSource time, Consumer<String> notice) {
        this.gaits = gaits;
        this.postures = postures;
        this.dog = dog;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Begins or renews a drive; called under the lock that orders the robot's motions.
     *
     * @throws MotionFailed if this drive has gone wrong since it was last renewed; the dog was stopped
     */
    public void drive(double mmPerSec, double degPerSec) {
        Stride stride = choose(mmPerSec, degPerSec);
        if (hasLapsed()) {
            fail(LATE);
        }
        refuseAfterFailure();
        if (wanted == null) {
            failureOfEnded = null;
        }
        if (stride != null && gaits.executor().current() == null) {
            postures.refuseFallen(dog.senses().posture());
        }
        renewedNanos = time.nanos();
        wanted = stride;
        if (stride == null) {
            halt();
            return;
        }
        announce(stride.gait());
        tick();
    }

    private void refuseAfterFailure() {
        String wrong = failure;
        if (wrong != null) {
            forget();
            throw new MotionFailed(wrong);
        }
    }

    /**
     * Checks a drive that has ended after its last renewal.
     *
     * @throws MotionFailed if something went wrong in it since that renewal
     */
    public void checkEnded() {
        String wrong = failureOfEnded;
        if (wrong != null) {
            throw new MotionFailed(wrong);
        }
    }

    private @Nullable Stride choose(double mmPerSec, double degPerSec) {
        Calibration calibration = dog.calibration();
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
        String wrong = failure;
        failureOfEnded = wrong == null ? failureOfEnded : wrong;
        wanted = null;
        announced = null;
        failure = null;
        underWay = false;
    }

    /** Ends the drive and sends the stop for everything that moves. */
    private void halt() {
        forget();
        gaits.halt();
    }

    /** Begins the next piece if it is time, or ends one that is no longer wanted. */
    void tick() {
        Stride stride = wanted;
        if (stride == null) {
            return;
        }
        if (hasLapsed()) {
            fail(LATE);
            return;
        }
        RunningMotion running = gaits.executor().current();
        String wrong = trouble(running);
        if (wrong != null) {
            fail(wrong);
        } else if (running == null) {
            begin(stride);
        } else if (running.piece() != null && running.piece().gait() != stride.gait() && !running.isStopRequested()) {
            gaits.halt();
        }
    }

    /** Whether the drive was not renewed in time, as when the program was suspended. */
    private boolean hasLapsed() {
        return wanted != null && time.secondsSince(renewedNanos) > LEASE_S;
    }

    private void fail(String wrong) {
        halt();
        failure = wrong;
    }

    /** Whether the drive must not go on; motors that are off before it has begun are switched on by it. */
    private @Nullable String trouble(@Nullable RunningMotion running) {
        String silence = gaits.silence();
        if (silence != null) {
            return silence;
        }
        boolean walks = running != null && running.piece() != null;
        if (walks && time.secondsSince(begunNanos) > OVERDUE_S) {
            return GaitControl.OVERDUE;
        }
        return underWay ? dog.senses().unfit() : null;
    }

    private synchronized void begin(Stride stride) {
        if (gaits.executor().current() != null) {
            return;
        }
        String wrong = settle();
        if (wrong != null) {
            fail(wrong);
            return;
        }
        RunningMotion rise = underWay ? null : postures.rise();
        if (rise != null) {
            latest = rise;
            gaits.start(rise, this::isWanted);
            return;
        }
        walk(stride);
    }

    private void walk(Stride stride) {
        underWay = true;
        gaits.armGuard();
        RunningMotion piece = gaits.piece(stride, PIECE_MS / stride.msPerUnit());
        latest = piece;
        begunNanos = time.nanos();
        if (gaits.start(piece, this::isWanted) && stride.gait() == Gait.FORWARD) {
            gaits.sweep().start();
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
            dog.senses().assumeMotors(true, ended.endedMs());
            dog.setStanding(true);
            return null;
        }
        return piece.flaw();
    }

    private boolean isWanted() {
        return wanted != null;
    }
}
