package majic.aibo.session;

import java.util.function.BooleanSupplier;
import majic.aibo.body.SensorReadings;
import majic.aibo.body.Stride;
import org.jspecify.annotations.Nullable;

/**
 * Starts and stops pieces of gaits, with everything that belongs to them: the guard on the dog, which is armed before
 * each, and the sweep of the head. Thread-safe.
 */
final class GaitControl {
    /** The failure when the end of a piece was not reported. */
    static final String OVERDUE = "the dog did not report the end of its walk in time; MAJIC stopped it";

    private final MotionExecutor executor;
    private final DogGuard guard;
    private final HeadSweep sweep;
    private final MessageRouter router;
    private final SensorReadings readings;

    GaitControl(
            MotionExecutor executor, DogGuard guard, HeadSweep sweep, MessageRouter router, SensorReadings readings) {
        this.executor = executor;
        this.guard = guard;
        this.sweep = sweep;
        this.router = router;
        this.readings = readings;
    }

    MotionExecutor executor() {
        return executor;
    }

    HeadSweep sweep() {
        return sweep;
    }

    /** Arms the guard, or renews it; to be sent before each piece. */
    void armGuard() {
        guard.renew();
    }

    /** Starts a piece, if the condition still holds once it is the current motion; returns whether it was started. */
    boolean start(RunningMotion piece, BooleanSupplier condition) {
        return executor.start(piece, condition);
    }

    /** Makes a piece that covers an amount, mm or degrees, to be started. */
    RunningMotion piece(Stride stride, double amount) {
        return executor.piece(stride, amount);
    }

    /** Sends the stop for everything that moves. */
    void halt() {
        executor.halt(sweep.halt());
    }

    /** Why a walking dog must be stopped, as half a sentence; null if there is no reason. */
    @Nullable
    String trouble() {
        String silent = silence();
        return silent == null ? readings.unfit() : silent;
    }

    /** The same, if it is that there are no new readings. */
    @Nullable
    String silence() {
        String silence = router.silence();
        return silence == null ? null : silence + "; MAJIC stops a dog without new readings";
    }
}
